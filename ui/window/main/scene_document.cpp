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
#include "ui/panels/parameter_text.h"

namespace asperity {

namespace {

constexpr int kMaxSteps = 500;

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
          isWheelTurning_ = false;
        else
          begin();
        break;
      case QEvent::Wheel:  // turning without a break is one gesture; after a drag a new one begins
        if (!std::exchange(isWheelTurning_, true)) ++present_;
        break;
      default:
        break;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  void begin() {
    ++present_;
    isWheelTurning_ = false;
  }

  std::uint64_t present_ = 0;
  bool isWheelTurning_ = false;
};

/// A command of the undo history, from one scene to the next.
class SceneStep : public QUndoCommand {
 public:
  SceneStep(SceneDocument& document, SceneState after, SceneChange change, std::uint64_t gesture,
            const char* what)
      : document_(document),
        before_{document.origin(), document.scene()},
        after_(std::move(after)),
        change_(change),
        keys_(differingKeys(before_.scene, after_.scene)),
        gesture_(gesture),
        what_(what) {
    updateName();
  }

  void updateName() {
    if (isOpening())
      setText(openedName(after_));
    else
      setText(what_ ? SceneDocument::tr(what_) : stepName(before_.scene, after_.scene));
  }

  /// Steps merge only with steps of the same number, which is not -1.
  int id() const override { return isOpening() ? -1 : 1; }

  void undo() override { document_.goTo(before_, change_); }

  void redo() override { document_.goTo(after_, change_); }

  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = *static_cast<const SceneStep*>(other);
    if (next.gesture_ != gesture_ || next.keys_ != keys_) return false;
    after_ = next.after_;
    setObsolete(after_.scene == before_.scene);
    return true;
  }

  bool isOpening() const { return change_ == SceneChange::Opened; }
  const SceneState& before() const { return before_; }

  /// Sets where the scene can be read again, after it was saved.
  void setOriginBefore(const SceneOrigin& origin) { before_.origin = origin; }
  void setOriginAfter(const SceneOrigin& origin) { after_.origin = origin; }

 private:
  static QString openedName(const SceneState& state) {
    constexpr int kMaxLength = 40;  // letters
    QString name = sceneText(state.scene.title);
    if (name.isEmpty()) name = QFileInfo(state.origin.file).fileName();
    if (name.isEmpty()) return SceneDocument::tr("Other scene");
    return SceneDocument::tr("Scene “%1”").arg(shortened(name, kMaxLength));
  }

  SceneDocument& document_;
  SceneState before_, after_;
  SceneChange change_;
  std::vector<std::string_view> keys_;
  std::uint64_t gesture_;
  const char* what_;
};

namespace {

SceneStep& stepAt(const QUndoStack& history, int index) {
  return *static_cast<SceneStep*>(const_cast<QUndoCommand*>(history.command(index)));
}

}  // namespace

SceneDocument::SceneDocument(const Scene& scene, QObject* parent)
    : QObject(parent), scene_(scene), gestures_(new GestureCounter(this)) {
  origin_.scene = scene;
  for (QUndoStack* history : {&history_, &trialHistory_}) {
    history->setUndoLimit(kMaxSteps);
    connect(history, &QUndoStack::indexChanged, this, &SceneDocument::historyChanged);
  }
  keepTranslated(*this, [this] { nameSteps(); });
}

/// Disconnects the histories, which emit signals while they are destroyed: this object is then
/// partly destroyed already.
SceneDocument::~SceneDocument() {
  for (QUndoStack* history : {&history_, &trialHistory_}) history->disconnect(this);
}

void SceneDocument::open(const SceneOrigin& origin) {
  endTrial();
  const SceneState next{origin, origin.scene};
  // Opening the same scene again restarts it, but there is nothing to undo.
  const bool isSame = next.scene == scene_ && origin.shipped == origin_.shipped &&
                      origin.file == origin_.file && origin.scene == origin_.scene;
  if (isSame) return goTo(next, SceneChange::Opened);
  if (const SceneState now{origin_, scene_}; now.isUnsavedFile()) leftUnsaved_[origin_.file] = now;
  leftUnsaved_.erase(origin.file);  // the opened state is the one on the disk
  history_.push(new SceneStep(*this, next, SceneChange::Opened, gestures_->present(), nullptr));
}

void SceneDocument::begin(const SceneState& state) {
  endTrial();
  if (state.scene == scene_)
    origin_ = state.origin;
  else
    goTo(state, SceneChange::Opened);
  history_.clear();
  emit historyChanged();
}

void SceneDocument::openTrial(const SceneOrigin& origin) {
  if (!isTrial()) beforeTrial_ = SceneState{origin_, scene_};
  trialHistory_.clear();
  goTo({origin, origin.scene}, SceneChange::Opened);
}

void SceneDocument::endTrial() {
  if (!isTrial()) return;
  const SceneState before = *std::exchange(beforeTrial_, std::nullopt);
  trialHistory_.clear();
  emit trialEnded();
  goTo(before, SceneChange::Opened);
}

std::vector<SceneState> SceneDocument::unsavedFiles() const {
  std::vector<SceneState> unsaved;
  QStringList named;
  const auto add = [&](const SceneState& state) {
    const QString& file = state.origin.file;
    if (file.isEmpty() || named.contains(file)) return;
    named += file;
    if (state.isUnsavedFile()) unsaved.push_back(state);
  };
  add(lastingState());
  for (int i = history_.index(); i-- > 0;)
    if (const SceneStep& step = stepAt(history_, i); step.isOpening()) add(step.before());
  for (const auto& [file, state] : leftUnsaved_) add(state);  // the history may have lost them
  return unsaved;
}

void SceneDocument::edit(const Scene& scene, const char* what) {
  change(scene, gestures_->present(), what);
}

void SceneDocument::change(const Scene& scene, std::uint64_t gesture, const char* what) {
  // Another kind may leave the axis of the curve without a meaning.
  const Scene next = withMeaningfulAxis(scene);
  if (next == scene_) return;
  history().push(new SceneStep(*this, {origin_, next}, SceneChange::Edited, gesture, what));
}

void SceneDocument::resetAll() {
  Scene scene;
  scene.folder = scene_.folder;
  edit(scene, QT_TR_NOOP("All parameters"));
}

void SceneDocument::revert() {
  edit(origin_.scene, QT_TR_NOOP("Revert to the opened scene"));
}

/// Names all steps again in the current language.
void SceneDocument::nameSteps() {
  for (QUndoStack* history : {&history_, &trialHistory_})
    for (int i = 0; i < history->count(); ++i) stepAt(*history, i).updateName();
  emit historyChanged();
}

/// The steps by which the scene was opened, and left for another one that may be redone, go to the
/// file from now on.
void SceneDocument::saved(const QString& file) {
  origin_ = {{}, file, scene_};
  leftUnsaved_.erase(file);
  const QUndoStack& steps = history();
  int opened = steps.index(), left = steps.index();
  while (--opened >= 0 && !stepAt(steps, opened).isOpening()) {
  }
  while (left < steps.count() && !stepAt(steps, left).isOpening()) ++left;
  for (int i = std::max(opened, 0); i < std::min(left + 1, steps.count()); ++i) {
    if (i >= opened && i < left) stepAt(steps, i).setOriginAfter(origin_);
    if (i > opened && i <= left) stepAt(steps, i).setOriginBefore(origin_);
  }
  emit historyChanged();
}

QString SceneDocument::name() const {
  const QString title = sceneText(scene_.title);
  return title.isEmpty() ? QFileInfo(file()).fileName() : title;
}

QString SceneDocument::proposedFile() const {
  if (!origin_.shipped.isEmpty() && scene_.title == origin_.scene.title)
    return origin_.shipped + QStringLiteral(".json");
  // Letters lose their accents; other characters between words become one underscore.
  static const QRegularExpression mark(QStringLiteral("\\p{M}"));
  static const QRegularExpression between(QStringLiteral("[^A-Za-z0-9]+"));
  const QString plain = QString::fromStdString(scene_.title)
                            .normalized(QString::NormalizationForm_KD)
                            .toLower()
                            .remove(mark);
  const QString words = plain.split(between, Qt::SkipEmptyParts).join('_');
  const std::string name = makeFileName(words.toStdString());
  return (name.empty() ? QStringLiteral("scene") : QString::fromStdString(name)) +
         QStringLiteral(".json");
}

void SceneDocument::goTo(const SceneState& state, SceneChange change) {
  const bool isOpened = change == SceneChange::Opened;
  if (isOpened) emit opening();
  scene_ = state.scene;
  origin_ = state.origin;
  if (isOpened) emit historyChanged();
  emit sceneChanged(scene_, change);
}

std::vector<std::string_view> differingKeys(const Scene& a, const Scene& b) {
  std::vector<std::string_view> keys;
  for (const Parameter& parameter : parameters())
    if (parameterValue(parameter, a) != parameterValue(parameter, b)) keys.push_back(parameter.key);
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
  if (choice != keys.end()) return capitalized(labelText(*findParameter(*choice)));
  if (keys.size() == 1) return capitalized(labelText(*findParameter(keys.front())));
  return SceneDocument::tr("%1 parameters").arg(keys.size());
}

}  // namespace asperity
