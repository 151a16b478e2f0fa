#include "ui/window/figures/figures_page.h"

#include <QClipboard>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPalette>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QSplitter>

#include "ui/chart/figure_drawing.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/panel_style.h"
#include "ui/window/figures/claims_table.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/figures/figure_list.h"
#include "ui/window/figures/figure_queue.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/message_bar.h"

namespace asperity {

namespace {

constexpr int kMaxRealizations = 10000;

/// Returns the style of the page in the colours of a palette: flat and rounded, as the window's
/// bars.
QString figuresStyleSheet(const QPalette& palette) {
  const auto tint = [&](int percent) {
    const QColor accent = palette.color(QPalette::Highlight);
    return QStringLiteral("rgba(%1, %2, %3, %4%)")
        .arg(accent.red())
        .arg(accent.green())
        .arg(accent.blue())
        .arg(percent);
  };
  return styleSheet(QStringLiteral(R"(
    #figuresBar { background: @window; border-top: 1px solid @edge; }
    #figuresNote { color: @faint; }
    QPushButton { background: @base; color: @text; border: 1px solid @edge; border-radius: 6px;
                  padding: 5px 12px; }
    QPushButton:hover, QPushButton:focus { border-color: @accent; }
    QPushButton:pressed { background: @edge; }
    QPushButton:disabled { background: transparent; color: @faint; }
    QProgressBar { background: @base; color: @text; border: 1px solid @edge; border-radius: 6px;
                   text-align: center; min-height: 26px; }
    QProgressBar::chunk { background: @progress; border-radius: 5px; }
    QTableWidget { selection-background-color: @selection; }
    QHeaderView { background: @window; border: none; }
    QHeaderView::section { background: @window; color: @faint; border: none;
                           border-bottom: 1px solid @edge; padding: 5px 8px; }
  )"),
                    palette, {{"progress", tint(35)}, {"selection", tint(18)}});
}

}  // namespace

FiguresPage::FiguresPage(FigureMaker maker, QWidget* parent)
    : QWidget(parent), queue_(new FigureQueue(std::move(maker), this)) {
  setObjectName("figuresPage");
  setStyle();
  messages_ = new MessageBar;
  auto* splitter = thinSplitter(Qt::Horizontal);
  splitter->addWidget(makeLeft());
  splitter->addWidget(makeRight());
  splitter->setStretchFactor(0, 0);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({270, 1000});

  auto* column = marginless<QVBoxLayout>(this, 0);
  column->addWidget(makeHeading());
  column->addWidget(messages_);
  column->addWidget(splitter, 1);

  connect(list_, &FigureList::chosenChanged, this, &FiguresPage::showChosen);
  connect(list_, &FigureList::computeRequested, this, &FiguresPage::compute);
  connect(queue_, &FigureQueue::changed, this, [this](FigureName name) {
    if (name == chosen())
      showChosen();
    else
      showWork();
  });
  connect(picture_, &DiagramView::failed, messages_,
          messages_->failureReporter(MessageBar::Failure::Scene));
  showChosen();
}

/// Sets the colours, and the texts that depend on what is computed and shown.
void FiguresPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) setStyle();
  if (event->type() != QEvent::LanguageChange) return;
  note_->clear();
  describePicture();
  // This runs later, because the buttons get the event after this page and first set their usual
  // texts.
  QMetaObject::invokeMethod(this, &FiguresPage::showWork, Qt::QueuedConnection);
}

void FiguresPage::setStyle() {
  const QString style = figuresStyleSheet(palette());
  if (style != styleSheet()) setStyleSheet(style);
}

FiguresPage::~FiguresPage() = default;

QWidget* FiguresPage::makeHeading() {
  auto* heading = new TitleBar("closeFigures");
  const auto close = [this] { emit closed(); };
  heading->leadBack(*this, close, close);
  keepTranslated(*heading, [heading] {
    heading->title().setText(tr("Figures of Li et al. (2013), computed here and now"));
  });
  return heading;
}

QWidget* FiguresPage::makeLeft() {
  auto* left = new QWidget;
  auto* column = marginless<QVBoxLayout>(left, 0);
  list_ = new FigureList(*queue_);
  column->addWidget(list_, 1);
  column->addWidget(makeChoices());
  return left;
}

/// Makes the choice of the number of lines, and the button that computes all figures.
QWidget* FiguresPage::makeChoices() {
  auto* choices = named<QWidget>("figuresBar");
  choices->setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(choices);
  column->setContentsMargins(12, 10, 12, 10);
  auto* row = new QHBoxLayout;
  auto* label = new QLabel;
  realizations_ = named<QSpinBox>("realizations");
  realizations_->setRange(1, kMaxRealizations);
  realizations_->setValue(kQuick);
  label->setBuddy(realizations_);
  keepTranslated(*choices, [this, label] {
    label->setText(tr("&Realizations"));
    realizations_->setAccessibleName(tr("realizations to average over"));
  });
  row->addWidget(label);
  row->addWidget(realizations_, 1);
  column->addLayout(row);
  auto* presets = new QHBoxLayout;
  presets->setSpacing(6);
  addButton(
      *presets, "quick", [] { return tr("&Quick"); },
      [] { return tr("%1 realizations").arg(kQuick); },
      [this] { realizations_->setValue(kQuick); });
  addButton(
      *presets, "paper", [] { return tr("Pap&er"); },
      [] { return tr("%1 realizations, as in the paper").arg(kPaper); },
      [this] { realizations_->setValue(kPaper); });
  presets->addStretch(1);
  addButton(
      *presets, "computeAll", [] { return tr("Compute &all"); },
      [] { return tr("All figures, one after another"); }, [this] { computeAll(); });
  column->addLayout(presets);
  return choices;
}

QWidget* FiguresPage::makeRight() {
  picture_ = named<DiagramView>("figurePicture");
  picture_->setMinimumSize(320, 200);
  picture_->setPause(0);
  picture_->setMinTextSize(0);
  claims_ = new ClaimsTable;
  auto* splitter = thinSplitter(Qt::Vertical);
  splitter->addWidget(picture_);
  splitter->addWidget(claims_);
  splitter->setStretchFactor(0, 7);
  splitter->setStretchFactor(1, 3);
  splitter->setSizes({700, 300});

  auto* right = new QWidget;
  auto* column = marginless<QVBoxLayout>(right, 0);
  column->addWidget(splitter, 1);
  column->addWidget(makeCommands());
  return right;
}

QWidget* FiguresPage::makeCommands() {
  auto* commands = named<QWidget>("figuresBar");
  commands->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(commands);
  row->setContentsMargins(12, 10, 12, 10);
  compute_ = addButton(
      *row, "compute", [] { return tr("&Compute"); },
      [] { return tr("Computes this figure from new lines (Enter in the list)"); },
      [this] { compute(); });
  cancel_ = addButton(
      *row, "cancel", [] { return tr("Ca&ncel"); },
      [] { return tr("Stops this computation and all that wait"); }, [this] { queue_->cancel(); });
  progress_ = named<QProgressBar>("figureProgress");
  progress_->setFormat(QStringLiteral("%p %"));
  progress_->setMinimumWidth(60);
  row->addWidget(progress_, 1);
  note_ = named<ElidedLabel>("figuresNote");
  row->addWidget(note_, 1);
  openScene_ = addButton(
      *row, "openAsScene", [] { return tr("&Open as scene"); },
      [] { return tr("This figure's parameters in the window, to play with"); },
      [this] { emit sceneRequested(shown_->figure.scene); });
  savePicture_ = addButton(
      *row, "savePicture", [] { return tr("Save &picture…"); },
      [] { return tr("PNG, SVG or PDF"); }, [this] { askPicture(); });
  saveData_ = addButton(
      *row, "saveData", [] { return tr("Save &data…"); },
      [] { return tr("The table as CSV, or the claims as JSON"); }, [this] { askData(); });
  keepTranslated(*progress_,
                 [this] { progress_->setAccessibleName(tr("progress of the computation")); });
  return commands;
}

QPushButton* FiguresPage::addButton(QLayout& row, const char* name, QString (*text)(),
                                    QString (*tip)(), std::function<void()> run) {
  auto* button = named<QPushButton>(name);
  keepTranslated(*button, [button, text, tip] {
    button->setText(text());
    button->setToolTip(tip());
  });
  connect(button, &QPushButton::clicked, this, std::move(run));
  row.addWidget(button);
  return button;
}

void FiguresPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  list_->setFocus();
}

FigureName FiguresPage::chosen() const {
  return list_->chosen();
}

/// Shows a text while there is no figure, and says to screen readers what there is.
void FiguresPage::describePicture() {
  const FigureStatus& status = queue_->status(chosen());
  if (status.made) {
    picture_->setAccessibleName(translatedText(status.made->figure.sheet.title));
    picture_->setAccessibleDescription(translatedText(status.made->figure.sheet.note));
  } else {
    const QString text = status.work == FigureStage::None
                             ? tr("%1 is not computed yet.")
                             : tr("%1 appears here once it is computed.");
    picture_->showText(text.arg(figureLabel(chosen())));
  }
}

void FiguresPage::showChosen() {
  const FigureStatus& status = queue_->status(chosen());
  describePicture();
  if (status.made != shown_) showComputed(status.made);
  // Why a file could not be written stays while the figure is computed again.
  if (status.error.isEmpty())
    messages_->end(MessageBar::Failure::Scene);
  else
    messages_->showFailure(MessageBar::Failure::Scene, status.error);
  showWork();
}

void FiguresPage::showComputed(std::shared_ptr<const ComputedFigure> made) {
  shown_ = std::move(made);
  claims_->setClaims(shown_ ? shown_->figure.claims : std::vector<Claim>());
  if (shown_)
    picture_->showPicture([made = shown_](const DiagramOptions& options) {
      return composeFigure(made->figure, made->contact.get(), options);
    });
  emit figureShown();
}

/// Enables the commands that make sense now.
void FiguresPage::showWork() {
  const FigureStatus& status = queue_->status(chosen());
  compute_->setText(status.made ? tr("&Compute again") : tr("&Compute"));
  compute_->setEnabled(status.work == FigureStage::None);
  for (QPushButton* button : {openScene_, savePicture_, saveData_})
    button->setEnabled(status.made != nullptr);
  const std::optional<FigureName> computing = queue_->computing();
  cancel_->setVisible(computing.has_value());
  progress_->setVisible(computing.has_value());
  note_->setVisible(!computing);
  if (!computing) return;
  showPart(*progress_, queue_->status(*computing).part);
  progress_->setToolTip(figureLabel(*computing));
}

void FiguresPage::choose(FigureName name, bool compute) {
  list_->choose(name);
  if (compute && !queue_->status(name).made) this->compute();
}

void FiguresPage::compute() {
  note_->clear();
  queue_->compute(chosen(), realizations_->value());
}

/// Computes the figures that are missing for this number of lines.
void FiguresPage::computeAll() {
  note_->clear();
  for (const FigureEntry& entry : figureEntries()) {
    const std::shared_ptr<const ComputedFigure> made = queue_->status(entry.name).made;
    if (!made || made->realizations != realizations_->value())
      queue_->compute(entry.name, realizations_->value());
  }
}

void FiguresPage::askPicture() {
  const QString file = askPictureFile(this, figureFile(chosen(), ".png"));
  if (!file.isEmpty()) savePicture(file);
}

void FiguresPage::askData() {
  const QString file = askSaveFile(this, tr("Save data"), figureFile(chosen(), ".csv"),
                                   tr("Table (*.csv);;Claims (*.json)"));
  if (!file.isEmpty()) saveData(file);
}

void FiguresPage::copyPicture() {
  if (!picture_->isPainted()) return;
  QGuiApplication::clipboard()->setImage(picture_->image());
  note_->setText(tr("The picture is on the clipboard"));
}

void FiguresPage::savePicture(const QString& file) {
  save(file, writeFigurePicture);
}

void FiguresPage::saveData(const QString& file) {
  save(file, writeFigureData);
}

void FiguresPage::save(const QString& file,
                       void (*write)(const std::filesystem::path&, const ComputedFigure&)) {
  const std::shared_ptr<const ComputedFigure> made = queue_->status(chosen()).made;
  if (!made) return;
  note_->setText(tr("Saving %1…").arg(QFileInfo(file).fileName()));
  saving_.request(
      [file, made, write](const BackgroundWork::Run&) { write(file.toStdString(), *made); },
      [this, file] {
        note_->setText(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
        if (messages_->end(MessageBar::Failure::Export)) showChosen();
      },
      [this](const LiveText& reason) {
        note_->clear();
        messages_->showFailure(MessageBar::Failure::Export, reason);
      });
}

}  // namespace asperity
