#include "ui/window/lesson/lesson_list.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <utility>

#include "core/lesson/lesson_file.h"
#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/window_layout.h"

namespace asperity {

namespace {

constexpr QSize kDefaultSize(820, 460);  // pixels

/// Returns the shipped lessons, which are read once.
const std::vector<Lesson>& readShippedLessons() {
  static const std::vector<Lesson> lessons = [] {
    std::vector<Lesson> read;
    for (const ShippedFile& lesson : shippedLessons())
      read.push_back(readNamedLesson(std::string(lesson.name), readNamedScene));
    return read;
  }();
  return lessons;
}

}  // namespace

LessonList::LessonList(QWidget* parent, AnswerFunction answer)
    : QDialog(parent),
      answer_(std::move(answer)),
      list_(named<QListWidget>("lessonNames")),
      notes_(named<QCheckBox>("lessonNotes")),
      about_(named<QLabel>("lessonAbout")),
      status_(named<QLabel>("lessonStatus")),
      saver_(new HandoutSaver(this)) {
  setObjectName("lessonList");
  list_->setWordWrap(true);
  for (const Lesson& lesson : readShippedLessons()) {
    auto* item = new QListWidgetItem;
    item->setData(Qt::UserRole, QString::fromStdString(lesson.name));
    list_->addItem(item);
  }
  status_->setWordWrap(true);
  status_->setMinimumHeight(fontMetrics().lineSpacing());
  auto* halves = new QHBoxLayout;
  halves->setSpacing(16);
  halves->addWidget(list_, 4);
  halves->addLayout(buildAbout(), 6);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(14, 12, 14, 12);
  all->addLayout(halves, 1);
  all->addWidget(status_);
  all->addLayout(buildFoot());
  resizeDialog(*this, kDefaultSize);
  connect(list_, &QListWidget::currentRowChanged, this, &LessonList::showChosen);
  connect(list_, &QListWidget::itemActivated, this, &LessonList::begin);
  connect(saver_, &HandoutSaver::statusChanged, this, [this](const QString& text) {
    showChosen();
    status_->setText(text);
  });
  list_->setCurrentRow(0);
  keepTranslated(*this, [this] { showTexts(); });
  list_->setFocus();
}

/// Makes the half that tells about the chosen lesson.
QLayout* LessonList::buildAbout() {
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::RichText);
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  about_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* scroll = scrolled(about_);
  keepTranslated(*scroll, [scroll] { scroll->setAccessibleName(tr("about the lesson")); });
  connect(list_, &QListWidget::currentRowChanged, scroll,
          [scroll] { scroll->verticalScrollBar()->setValue(0); });
  connect(notes_, &QCheckBox::toggled, this, &LessonList::showChosen);
  auto* column = new QVBoxLayout;
  column->addWidget(scroll, 1);
  column->addWidget(notes_);  // they contain answers, which students should not read by chance
  return column;
}

QLayout* LessonList::buildFoot() {
  start_ = pageButton("lessonStart", {}, this, &LessonList::begin);
  start_->setDefault(true);
  open_ = pageButton("lessonOpen", {}, this, &LessonList::askFile);
  handout_ = pageButton("lessonHandout", {}, this, [this] {
    if (list_->currentRow() < 0) return;
    saver_->ask(readShippedLessons()[static_cast<std::size_t>(list_->currentRow())], chosen());
  });
  edit_ = pageButton("lessonEdit", {}, this, [this] {
    emit editorRequested(chosen());
    accept();
  });
  close_ = pageButton("lessonClose", {}, this, &QDialog::reject);
  return buttonRow({open_, edit_, handout_}, {close_, start_});
}

void LessonList::showTexts() {
  setWindowTitle(tr("Lessons"));
  list_->setAccessibleName(tr("lessons"));
  for (int i = 0; i < list_->count(); ++i) {
    const Lesson& lesson = readShippedLessons()[static_cast<std::size_t>(i)];
    list_->item(i)->setText(QStringLiteral("%1. ").arg(i + 1) + plainText(lesson.title));
  }
  notes_->setText(tr("Show the notes for &teachers, with answers"));
  start_->setText(tr("&Begin"));
  open_->setText(tr("&Open lesson or results…"));
  open_->setToolTip(tr("Several files of results make a table of the class"));
  handout_->setText(tr("&Handout…"));
  edit_->setText(tr("&Edit a copy…"));
  close_->setText(tr("&Close"));
  showChosen();
}

QString LessonList::chosen() const {
  const QListWidgetItem* item = list_->currentItem();
  return item ? item->data(Qt::UserRole).toString() : QString();
}

void LessonList::showChosen() {
  const int row = list_->currentRow();
  for (QPushButton* button : {start_, handout_, edit_})
    button->setEnabled(row >= 0 && !(button == handout_ && saver_->isSaving()));
  computeAnswers(notes_->isChecked() && row >= 0 && !answers_.contains(row) ? row : -1);
  showAbout();
}

void LessonList::showAbout() {
  const int row = list_->currentRow();
  if (row < 0) return about_->clear();
  const Lesson& lesson = readShippedLessons()[static_cast<std::size_t>(row)];
  QString html = "<h3>" + plainText(lesson.title).toHtmlEscaped() + "</h3><p>" +
                 tr("%1 minutes, %2 steps").arg(lesson.minutes).arg(lesson.steps.size()) + "</p>" +
                 lessonHtml(shown(lesson.goal));
  if (notes_->isChecked()) html += teacherText(row);
  about_->setText(html);
}

/// Computes the right answers to the questions of a lesson, and shows them. row: -1 for none, which
/// stops a computation that is no longer needed.
void LessonList::computeAnswers(int row) {
  if (row == computedRow_) return;
  computedRow_ = row;
  if (row < 0) return answering_.cancel();
  status_->clear();
  answering_.request(
      [row, answer = answer_](const BackgroundWork::Run& run) {
        CurveOptions options;
        options.stop = run.stop();
        std::vector<LessonAnswer> answers;
        for (const LessonStep& step : readShippedLessons()[static_cast<std::size_t>(row)].steps)
          answers.push_back(step.prediction ? answer(step, options) : LessonAnswer());
        return answers;
      },
      [this, row](std::vector<LessonAnswer> answers) {
        answers_[row] = std::move(answers);
        showChosen();
      },
      [this](const QString& reason) {
        computedRow_ = -1;  // they are tried again when the lesson is shown again
        status_->setText(reason);
        showAbout();
      });
}

/// Returns the notes and the answers, as HTML.
QString LessonList::teacherText(int row) const {
  const Lesson& lesson = readShippedLessons()[static_cast<std::size_t>(row)];
  QString html = "<h4>" + tr("For teachers") + "</h4>";
  if (!lesson.notes.empty()) html += lessonHtml(shown(lesson.notes));
  html += "<h4>" + tr("Answers") + "</h4>";
  const auto found = answers_.find(row);
  if (found == answers_.end())
    return html + "<p>" +
           (row == computedRow_ ? tr("They are being computed…")
                                : tr("They could not be computed.")) +
           "</p>";
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    if (const auto& prediction = lesson.steps[i].prediction)
      html += QStringLiteral("<p>%1. %2<br><b>%3</b></p>")
                  .arg(i + 1)
                  .arg(plainText(prediction->question).toHtmlEscaped(),
                       answerInWords(*prediction, found->second[i]).toHtmlEscaped());
  return html;
}

void LessonList::begin() {
  const QString name = chosen();
  if (name.isEmpty()) return;
  accept();
  emit lessonRequested(name);
}

void LessonList::askFile() {
  const QStringList files =
      askOpenFiles(this, tr("Open a lesson or the results of students"), proposedFolder(),
                   tr("Lessons and results (*.json);;All files (*)"));
  if (files.isEmpty()) return;
  accept();
  if (files.size() == 1)
    emit lessonRequested(files.first());
  else
    emit resultsRequested(files);
}

}  // namespace asperity
