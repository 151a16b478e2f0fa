#include "ui/window/main/scene_document.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QKeyEvent>
#include <QRegularExpression>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/scene/parameters.h"
#include "core/scene/sweep.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_row.h"

namespace asperity {

namespace {

constexpr int kMostSteps = 500;

QString capitalized(const QString& text) {
  return text.left(1).toUpper() + text.mid(1);
}

}  // namespace

/// Numbers the gestures of a user: pressing a button or a key begins a new one; movements, repeats
/// and wheel steps until the next press belong to it. It watches the whole application.
class GestureCounter : public QObject {
 public:
  explicit GestureCounter(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

  std::uint64_t present() const { return present_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    switch (event->type()) {
      case QEvent::MouseButtonPress:
      case QEvent::MouseButtonDblClick:
      case QEvent::TouchBegin:
      case QEvent::Shortcut:
        begin();
        break;
      case QEvent::KeyPress:
        if (static_cast<QKeyEvent*>(event)->isAutoRepeat())
          isTurning_ = false;
        else
          begin();
        break;
      case QEvent::Wheel:  // turning on is one gesture; turning after a drag is another
        if (!std::exchange(isTurning_, true)) ++present_;
        break;
      default:
        break;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  void begin() {
    ++present_;
    isTurning_ = false;
  }

  std::uint64_t present_ = 0;
  bool isTurning_ = false;  // the wheel
};

/// A step of the history, from one scene to the next.
class SceneStep : public QUndoCommand {
 public:
  SceneStep(SceneDocument& document, Scene after, std::uint64_t gesture, const char* what)
      : document_(document),
        before_(document.scene()),
        after_(std::move(after)),
        keys_(differingKeys(before_, after_)),
        gesture_(gesture),
        what_(what) {
    takeName();
  }

  void takeName() { setText(what_ ? SceneDocument::tr(what_) : stepName(before_, after_)); }

  int id() const override { return 1; }

  void undo() override { document_.goTo(before_); }

  void redo() override { document_.goTo(after_); }

  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = *static_cast<const SceneStep*>(other);
    if (next.gesture_ != gesture_ || next.keys_ != keys_) return false;
    after_ = next.after_;
    setObsolete(after_ == before_);
    return true;
  }

 private:
  SceneDocument& document_;
  Scene before_, after_;
  std::vector<std::string_view> keys_;
  std::uint64_t gesture_;
  const char* what_;
};

SceneDocument::SceneDocument(const Scene& scene, QObject* parent)
    : QObject(parent), scene_(scene), gestures_(new GestureCounter(this)) {
  origin_.scene = scene;
  history_.setUndoLimit(kMostSteps);
  connect(&history_, &QUndoStack::indexChanged, this, &SceneDocument::historyChanged);
  keepTranslated(*this, [this] { nameSteps(); });
}

/// QUndoStack emits signals while it is destroyed, when this object is partly destroyed already.
SceneDocument::~SceneDocument() {
  history_.disconnect(this);
}

void SceneDocument::open(const SceneOrigin& origin) {
  emit opening();
  origin_ = origin;
  isTrial_ = false;
  scene_ = origin.scene;
  history_.clear();
  emit historyChanged();
  emit sceneChanged(scene_, SceneChange::Opened);
}

void SceneDocument::edit(const Scene& scene, const char* what) {
  change(scene, gestures_->present(), what);
}

void SceneDocument::change(const Scene& scene, std::uint64_t gesture, const char* what) {
  // Another kind may leave the axis of the curve without a meaning.
  const Scene next = withMeaningfulAxis(scene);
  if (next == scene_) return;
  history_.push(new SceneStep(*this, next, gesture, what));
}

void SceneDocument::resetAll() {
  Scene scene;
  scene.folder = scene_.folder;
  edit(scene, QT_TR_NOOP("All parameters"));
}

void SceneDocument::revert() {
  edit(origin_.scene, QT_TR_NOOP("Back to the scene as opened"));
}

/// Names all steps again in the current language.
void SceneDocument::nameSteps() {
  for (int i = 0; i < history_.count(); ++i)
    static_cast<SceneStep*>(const_cast<QUndoCommand*>(history_.command(i)))->takeName();
  emit historyChanged();
}

void SceneDocument::saved(const QString& file) {
  origin_ = {{}, file, scene_};
  emit historyChanged();
}

QString SceneDocument::name() const {
  const QString title = sceneText(scene_.title);
  return title.isEmpty() ? QFileInfo(file()).fileName() : title;
}

QString SceneDocument::proposedFile() const {
  if (!origin_.shipped.isEmpty()) return origin_.shipped + QStringLiteral(".json");
  // Letters lose their accents, and other signs between words become one sign.
  static const QRegularExpression mark(QStringLiteral("\\p{M}"));
  static const QRegularExpression between(QStringLiteral("[^A-Za-z0-9]+"));
  const QString plain = QString::fromStdString(scene_.title)
                            .normalized(QString::NormalizationForm_KD)
                            .toLower()
                            .remove(mark);
  const QString words = plain.split(between, Qt::SkipEmptyParts).join('_');
  const std::string name = fileNameOf(words.toStdString());
  return (name.empty() ? QStringLiteral("scene") : QString::fromStdString(name)) +
         QStringLiteral(".json");
}

void SceneDocument::goTo(const Scene& scene) {
  scene_ = scene;
  emit sceneChanged(scene_, SceneChange::Edited);
}

std::vector<std::string_view> differingKeys(const Scene& a, const Scene& b) {
  std::vector<std::string_view> keys;
  for (const Parameter& parameter : parameters())
    if (valueOf(parameter, a) != valueOf(parameter, b)) keys.push_back(parameter.key);
  return keys;
}

/// Returns the name of a step of the history. If a choice changed, its name is used, because a
/// choice changes other parameters too.
QString stepName(const Scene& before, const Scene& after) {
  const std::vector<std::string_view> keys = differingKeys(before, after);
  const auto isChoice = [](std::string_view key) {
    return std::holds_alternative<ChoiceField>(findParameter(key)->field);
  };
  const auto choice = std::ranges::find_if(keys, isChoice);
  if (choice != keys.end()) return capitalized(ParameterRow::labelOf(*findParameter(*choice)));
  if (keys.size() == 1) return capitalized(ParameterRow::labelOf(*findParameter(keys.front())));
  return SceneDocument::tr("%1 parameters").arg(keys.size());
}

}  // namespace asperity
