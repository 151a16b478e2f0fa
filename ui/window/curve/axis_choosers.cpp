#include "ui/window/curve/axis_choosers.h"

#include <QAbstractItemView>
#include <QFocusEvent>
#include <QSignalBlocker>
#include <algorithm>
#include <functional>

#include "core/chart/curve_words.h"
#include "core/scene/parameters.h"
#include "core/scene/sweep.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/friction_chart_model.h"
#include "ui/language/explained.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/number_text.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

/// The entry of both lists that stands for the axes of Eq. (13); no key has this name.
const QString kDimensionless = QStringLiteral("dimensionless");

QString entryText(const Message& title, std::string_view unit) {
  const QString text = capitalized(translatedText(title));
  return unit.empty() ? text : QStringLiteral("%1 (%2)").arg(text, fromUtf8(unit));
}

}  // namespace

/// A list whose entries are made when it opens, because finding the parameters of a scene takes a
/// while.
class AxisBox : public ChoiceBox {
 public:
  using Fill = std::function<void()>;

  explicit AxisBox(Fill fill) : fill_(std::move(fill)) {
    setMinimumContentsLength(4);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  }

  void showPopup() override {
    fill_();
    // The list is as wide as its entries, not as the box.
    view()->setMinimumWidth(view()->sizeHintForColumn(0) + 24);
    ChoiceBox::showPopup();
  }

 protected:
  void focusInEvent(QFocusEvent* event) override {
    if (event->reason() != Qt::PopupFocusReason) fill_();
    ChoiceBox::focusInEvent(event);
  }

 private:
  Fill fill_;
};

namespace {

/// Sets the entries if they have changed: the list may be open.
void setEntries(AxisBox& box, const QList<std::pair<QString, QVariant>>& entries) {
  bool isSame = box.count() == entries.size();
  for (int i = 0; isSame && i < box.count(); ++i)
    isSame = box.itemText(i) == entries[i].first && box.itemData(i) == entries[i].second;
  if (isSame) return;
  const QSignalBlocker blocker(box);
  box.clear();
  for (const auto& [text, data] : entries) box.addItem(text, data);
}

}  // namespace

AxisChoosers::AxisChoosers(Session& session, ChartView& view, CurveCommands& commands)
    : QObject(&commands),
      session_(session),
      commands_(commands),
      x_(new AxisBox([this] { fillKeys(); })),
      y_(new AxisBox([this] { fillQuantities(); })) {
  x_->setObjectName("axisKey");
  y_->setObjectName("axisQuantity");
  connect(x_, &QComboBox::activated, this, [this](int index) {
    const QString key = x_->itemData(index).toString();
    commands_.chooseAxis(key == kDimensionless ? nullptr : findParameter(key.toStdString()));
    update();
  });
  connect(y_, &QComboBox::activated, this, [this](int index) {
    if (y_->itemData(index).toString() == kDimensionless)
      commands_.chooseAxis(nullptr);
    else
      commands_.chooseQuantity(static_cast<CurveQuantity>(y_->itemData(index).toInt()));
    update();
  });
  view.setChoosers(x_, y_);
  connect(&view, &ChartView::titlesChanged, this, &AxisChoosers::showTitles);
  keepTranslated(*x_, [this] { showTexts(); });
}

void AxisChoosers::showTexts() {
  x_->setAccessibleName(tr("horizontal axis"));
  y_->setAccessibleName(tr("vertical axis"));
  for (AxisBox* box : {x_, y_}) box->view()->setAccessibleName(box->accessibleName());
  fillKeys();
  fillQuantities();
}

/// Shows the titles as they fit the visible range, with the unit of the ticks.
void AxisChoosers::showTitles(const QString& x, const QString& y) {
  x_->setShownText(x);
  y_->setShownText(y);
  update();
}

void AxisChoosers::fillKeys() {
  QList<std::pair<QString, QVariant>> entries;
  for (const Parameter* row : commands_.axisKeys())
    entries.emplaceBack(entryText(parameterTitle(row->key), row->unit), fromUtf8(row->key));
  entries.insert(1, {tr("Dimensionless velocity v̄, Eq. (13)"), kDimensionless});
  setEntries(*x_, entries);
  update();
}

void AxisChoosers::fillQuantities() {
  QList<std::pair<QString, QVariant>> entries;
  for (const QuantityEntry& entry : quantityEntries())
    entries.emplaceBack(entryText(entry.title, entry.unit), static_cast<int>(entry.quantity));
  if (session_.scene().sweep.isOfVelocity())
    entries.emplaceBack(tr("Dimensionless: μ over the rms slope against v̄"), kDimensionless);
  setEntries(*y_, entries);
  update();
}

/// Sets the tooltips that explain the axes.
void AxisChoosers::explain() {
  const bool isPlain = !commands_.hasDimensionlessAxes();
  const Rheology rheology = session_.scene().elastomer.rheology;
  const auto tip = [rheology](std::string_view id, const QString& hint) {
    const auto explanation = findExplanation(id);
    return (explanation ? explanationHtml(withFormulaFor(*explanation, rheology)) : QString()) +
           "<p><small>" + hint.toHtmlEscaped() + "</small></p>";
  };
  x_->setToolTip(
      tip(isPlain ? std::string_view(session_.scene().sweep.key) : "dimensionless_velocity",
          tr("What the curve goes over: any number that changes friction in this scene. "
             "The marker then sets it.")));
  y_->setToolTip(tip(isPlain ? std::string_view(quantityEntry(session_.friction().quantity()).word)
                             : "normalized_mu",
                     tr("What the curve shows")));
}

/// Selects what is shown.
void AxisChoosers::update() {
  const QSignalBlocker blockX(x_), blockY(y_);
  const bool isPlain = !commands_.hasDimensionlessAxes();
  const QString key = QString::fromStdString(session_.scene().sweep.key);
  x_->setCurrentIndex(x_->findData(isPlain ? key : kDimensionless));
  const auto quantity = static_cast<int>(session_.friction().quantity());
  y_->setCurrentIndex(y_->findData(isPlain ? QVariant(quantity) : QVariant(kDimensionless)));
  explain();
}

}  // namespace asperity
