#include "ui/window/lesson/prediction_fields.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QShortcut>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <cmath>

#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/window/lesson/lesson_form.h"
#include "ui/window/lesson/lesson_validation.h"
#include "ui/window/lesson/lesson_value_fields.h"

namespace asperity {

namespace {

constexpr int kMaxChoices = 6;

enum Kind { kNone, kChoice, kNumber, kPoint };                               // as in the list
enum CurveVisibility { kVisible, kHiddenUntilAnswered, kHiddenThroughout };  // as in the list

constexpr int kPlaceholderRole = Qt::UserRole + 1;

/// Shows the placeholder of an empty cell.
class PlaceholderDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!option->text.isEmpty()) return;
    option->text = index.data(kPlaceholderRole).toString();
    option->features |= QStyleOptionViewItem::HasDisplay;
    option->palette.setColor(QPalette::Text, option->palette.color(QPalette::PlaceholderText));
  }
};

QString endText(double end) {
  return std::isfinite(end) ? shownNumber(end) : QString();
}
constexpr double kPointTolerance = 1;  // a factor of 2 on a logarithmic axis

}  // namespace

PredictionFields::PredictionFields(LessonForm& page) : QObject(&page), page_(page) {
  kind_ = page.addChoice(tr("Prediction"), "editorKind");
  kind_->addItems({tr("none"), tr("a choice"), tr("a number"), tr("a point on the chart")});
  connect(kind_, &QComboBox::activated, this, [this] {
    showRows();
    proposeTolerance();
    page_.notifyEdited();
  });
  question_ = page.addText(tr("Question"), "editorQuestion", 2);
  addChoices();
  value_ = new LessonValueFields(page);
  computed_ = new WrappedLabel;
  computed_->setObjectName("editorComputed");
  page.addRow(QString(), computed_);
  page.setShown(computed_, false);
  x_ = page.addLine(tr("Place on the axis"), "editorX");
  x_->setPlaceholderText(tr("empty: the largest value is asked"));
  connect(x_, &QLineEdit::textEdited, this, &PredictionFields::showRowsOfPoint);
  tolerance_ = page.addLine(tr("Tolerance in %"), "editorTolerance");
  tolerance_->setToolTip(tr(
      "How far a right answer may be from the computed one; of a point, the factor on the chart is "
      "1.5 for 50 %"));
  xTolerance_ = page.addLine(tr("Tolerance of the place in %"), "editorPlaceTolerance");
  xTolerance_->setToolTip(
      tr("How far the place of a right answer may be from that of the largest value: the factor is "
         "2 for 100 %"));
  right_ = page.addLine(tr("If right"), "editorRight");
  wrong_ = page.addLine(tr("If wrong"), "editorWrong");
  hides_ = page.addChoice(tr("The curve is"), "editorHides");
  hides_->addItems({tr("in sight"), tr("hidden until the answer"), tr("hidden throughout")});
  after_ = page.addAssignments(tr("Changed with the answer"), "editorAfter");
  after_->setToolTip(tr("What the program changes in the scene when the answer is shown"));
  reveal_ = page.addText(tr("Said with the answer"), "editorReveal", 4);
  for (QWidget* text : Widgets{right_, wrong_, reveal_})
    text->setToolTip(tr(
        "Write {answer} where the computed answer or the right choice belongs, and {given} where "
        "the student's does; *italic*, **bold**"));
}

void PredictionFields::addChoices() {
  choices_ = new QTableWidget(kMaxChoices, 4);
  choices_->setObjectName("editorChoices");
  choices_->setAccessibleName(tr("choices"));
  choices_->setHorizontalHeaderLabels({tr("Choice"), tr("Right"), tr("From"), tr("To")});
  choices_->setToolTip(
      tr("Tick the right one; or leave all unticked, give the range of the "
         "computed answer for which each is right, and say below what is computed"));
  choices_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  const int digit = choices_->fontMetrics().horizontalAdvance('0');
  for (const auto& [column, digits] : {std::pair(1, 7), {2, 8}, {3, 8}})
    choices_->setColumnWidth(column, digits * digit);
  choices_->verticalHeader()->hide();
  // Long choices are wrapped: rows are as high as their texts, and the table as high as its rows.
  choices_->verticalHeader()->setMinimumSectionSize(choices_->fontMetrics().lineSpacing() + 10);
  const auto fitHeights = [this] {
    choices_->resizeRowsToContents();
    choices_->setFixedHeight(choices_->horizontalHeader()->sizeHint().height() +
                             choices_->verticalHeader()->length() + 2 * choices_->frameWidth());
  };
  connect(choices_->model(), &QAbstractItemModel::dataChanged, choices_, fitHeights);
  connect(choices_->horizontalHeader(), &QHeaderView::sectionResized, choices_, fitHeights);
  choices_->setTabKeyNavigation(false);
  choices_->setItemDelegateForColumn(0, new PlaceholderDelegate(choices_));
  for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
    // Only of the table itself: in a cell that is being edited the keys delete letters.
    auto* shortcut = new QShortcut(QKeySequence(key), choices_);
    shortcut->setContext(Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, this, &PredictionFields::emptySelectedCells);
  }
  page_.addRow(tr("Choices"), choices_);
  connect(choices_, &QTableWidget::itemChanged, &page_, &LessonForm::notifyEdited);
}

/// Empties the selected cells but for the ticks, as one edit.
void PredictionFields::emptySelectedCells() {
  {
    const QSignalBlocker quiet(choices_);
    for (QTableWidgetItem* item : choices_->selectedItems())
      if (item->column() != 1) item->setText({});
  }
  page_.notifyEdited();
}

// ---- Showing

void PredictionFields::show(const LessonStep& step) {
  const LessonPrediction prediction = step.prediction.value_or(LessonPrediction{});
  axis_ = step.scene.sweep.key;
  isLinearY_ = step.show.isLinearY;
  kind_->setCurrentIndex(step.prediction ? 1 + static_cast<int>(prediction.kind) : kNone);
  page_.showText(*question_, prediction.question);
  const QString places =
      tr("{answer}: the right answer; {given}: that of the student");  // the tooltip says more
  page_.showText(*right_, prediction.right, places);
  page_.showText(*wrong_, prediction.wrong, places);
  tolerance_->setText(percentText(prediction.tolerance));
  xTolerance_->setText(percentText(prediction.xTolerance));
  x_->setText(prediction.x ? keyValueText(axis_, *prediction.x) : QString());
  value_->show(prediction.answer.value_or(LessonValue{}), step.scene);
  hides_->setCurrentIndex(!step.show.hidesCurve       ? kVisible
                          : step.show.hidesCurveAfter ? kHiddenThroughout
                                                      : kHiddenUntilAnswered);
  after_->show(step.after, step.revealedScene);
  page_.showText(*reveal_, step.reveal, places);
  showChoices(prediction);
  showRows();
}

void PredictionFields::showChoices(const LessonPrediction& prediction) {
  for (int i = 0; i < kMaxChoices; ++i) {
    const bool has = i < static_cast<int>(prediction.choices.size());
    const LessonChoice choice =
        has ? prediction.choices[static_cast<std::size_t>(i)] : LessonChoice{};
    auto* tick = new QTableWidgetItem;
    tick->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    tick->setCheckState(choice.isRight ? Qt::Checked : Qt::Unchecked);
    auto* text = new QTableWidgetItem(page_.localText(choice.text));
    text->setData(kPlaceholderRole, page_.placeholder(choice.text));
    choices_->setItem(i, 0, text);
    choices_->setItem(i, 1, tick);
    choices_->setItem(i, 2, new QTableWidgetItem(endText(choice.above)));
    choices_->setItem(i, 3, new QTableWidgetItem(endText(choice.below)));
  }
}

/// Shows the rows that the kind of prediction has.
void PredictionFields::showRows() {
  const int kind = kind_->currentIndex();
  for (QWidget* field : Widgets{question_, right_, wrong_, after_, reveal_})
    page_.setShown(field, kind != kNone);
  page_.setShown(choices_, kind == kChoice);
  value_->setShown(kind == kChoice || kind == kNumber);
  page_.setShown(x_, kind == kPoint);
  page_.setShown(tolerance_, kind == kNumber || kind == kPoint);
  showRowsOfPoint();
}

/// Shows the tolerance of the place where the place is asked for. The curve of a point is never
/// visible before the answer, but it may stay hidden after it.
void PredictionFields::showRowsOfPoint() {
  const bool isPoint = kind_->currentIndex() == kPoint;
  page_.setShown(xTolerance_, isPoint && x_->text().trimmed().isEmpty());
  qobject_cast<QStandardItemModel*>(hides_->model())->item(kVisible)->setEnabled(!isPoint);
  if (isPoint && hides_->currentIndex() == kVisible) hides_->setCurrentIndex(kHiddenUntilAnswered);
}

void PredictionFields::showComputed(const QString& text) {
  computed_->setText(text);
  page_.setShown(computed_, !text.isEmpty());
}

/// Where a point is asked for from now on, its usual tolerance is a factor: on a logarithmic axis
/// of several decades a tenth of a value is one pixel. A number gets the usual one back.
void PredictionFields::proposeTolerance() {
  const bool isPoint = kind_->currentIndex() == kPoint;
  const QString usual = percentText(LessonPrediction{}.tolerance);
  const QString factor = percentText(kPointTolerance);
  if (isPoint && !isLinearY_ && tolerance_->text() == usual) tolerance_->setText(factor);
  if (!isPoint && tolerance_->text() == factor) tolerance_->setText(usual);
}

// ---- Taking what is written

/// Writes the choices into the prediction. Returns whether they have ranges of a computed answer.
bool PredictionFields::takeChoices(LessonPrediction& prediction) const {
  prediction.choices.clear();
  bool hasRanges = false;
  for (int i = 0; i < kMaxChoices; ++i) {
    LessonChoice choice;
    const QTableWidgetItem& text = *choices_->item(i, 0);
    // The text in the other language stays with its row, also where a row above is empty.
    page_.write(choice.text, text.text(), text.data(kPlaceholderRole).toString());
    choice.isRight = choices_->item(i, 1)->checkState() == Qt::Checked;
    choice.above = numberIn(choices_->item(i, 2)->text()).value_or(LessonChoice{}.above);
    choice.below = numberIn(choices_->item(i, 3)->text()).value_or(LessonChoice{}.below);
    if (choice.text.empty()) continue;
    hasRanges = hasRanges || choice.isRange();
    prediction.choices.push_back(choice);
  }
  if (hasRanges)
    for (LessonChoice& choice : prediction.choices) choice.isRight = false;
  return hasRanges;
}

void PredictionFields::take(LessonStep& step) const {
  step.show.hidesCurve = hides_->currentIndex() != kVisible;
  step.show.hidesCurveAfter = hides_->currentIndex() == kHiddenThroughout;
  const int kind = kind_->currentIndex();
  const bool wasComputed = step.prediction && step.prediction->answer;
  const std::vector<std::string> changesBefore =
      wasComputed ? step.prediction->answer->set : std::vector<std::string>();
  if (kind == kNone) {
    step.prediction.reset();
    step.reveal = {};
    step.after.clear();
    step.values.clear();
    return;
  }
  LessonPrediction prediction = step.prediction.value_or(LessonPrediction{});
  prediction.kind = static_cast<PredictionKind>(kind - 1);
  page_.write(prediction.question, LessonForm::plainText(*question_));
  page_.write(prediction.right, right_->text());
  page_.write(prediction.wrong, wrong_->text());
  prediction.tolerance = partIn(tolerance_->text(), prediction.tolerance);
  prediction.xTolerance = partIn(xTolerance_->text(), prediction.xTolerance);
  if (kind != kPoint || unreadableIn(*x_).isEmpty())
    prediction.x = kind == kPoint ? parseKeyValue(axis_, x_->text()) : std::nullopt;
  if (kind != kChoice || unreadableChoice().isEmpty()) {
    const bool isComputed = kind == kNumber || (kind == kChoice && takeChoices(prediction));
    if (kind != kChoice) prediction.choices.clear();
    if (isComputed)
      prediction.answer = value_->edited(prediction.answer.value_or(LessonValue{}));
    else
      prediction.answer.reset();
  }
  step.prediction = prediction;
  // The curve would show a number that is asked for from now on.
  if (!wasComputed && showsAnswer(step)) {
    step.show.hidesCurve = true;
    hides_->setCurrentIndex(kHiddenUntilAnswered);
  }
  step.after = after_->assignments();
  // The picture follows the changes of the answer, until it is given other ones.
  const std::vector<std::string> changes =
      prediction.answer ? prediction.answer->set : std::vector<std::string>();
  if (changes != changesBefore && step.after == changesBefore) {
    step.after = changes;
    after_->show(step.after, step.scene);
  }
  page_.write(step.reveal, LessonForm::plainText(*reveal_));
}

// ---- What cannot be read

QString PredictionFields::unreadableIn(const QLineEdit& line) const {
  const QString text = line.text().trimmed();
  const bool isPlace = &line == x_;
  if (!line.isVisibleTo(&page_) || (isPlace && text.isEmpty())) return {};
  const bool isRead = isPlace ? parseKeyValue(axis_, text).has_value()
                              : numberIn(QString(text).remove('%')).has_value();
  return isRead ? QString() : tr("%1: “%2” is not a number").arg(line.accessibleName(), text);
}

QString PredictionFields::unreadableChoice() const {
  if (!choices_->isVisibleTo(&page_)) return {};
  for (int row = 0; row < choices_->rowCount(); ++row)
    for (const int column : {2, 3}) {
      const QTableWidgetItem* item = choices_->item(row, column);  // none: no step was shown yet
      const QString text = item ? item->text().trimmed() : QString();
      if (text.isEmpty() || numberIn(text)) continue;
      return tr("Choice %1, %2: “%3” is not a number")
          .arg(row + 1)
          .arg(choices_->horizontalHeaderItem(column)->text(), text);
    }
  return {};
}

QString PredictionFields::unreadable() const {
  for (const QLineEdit* line : {x_, tolerance_, xTolerance_})
    if (const QString text = unreadableIn(*line); !text.isEmpty()) return text;
  return unreadableChoice();
}

}  // namespace asperity
