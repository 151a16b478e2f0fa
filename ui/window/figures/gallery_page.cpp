#include "ui/window/figures/gallery_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QSpinBox>
#include <QSplitter>
#include <QToolButton>

#include "ui/panels/number_text.h"
#include "ui/window/main/appearance.h"
#include "ui/window/figures/claims_table.h"
#include "ui/window/figures/figure_list.h"
#include "ui/window/figures/figure_picture.h"
#include "ui/window/figures/gallery_style.h"
#include "ui/window/main/message_bar.h"

namespace asperity {

namespace {

constexpr int kMostRealizations = 10000;
constexpr int kSteps = 1000;  // of the progress bar

}  // namespace

GalleryPage::GalleryPage(FigureMaker maker, QWidget* parent)
    : GalleryPage(std::make_unique<FigureGallery>(std::move(maker)), parent) {}

GalleryPage::GalleryPage(std::unique_ptr<FigureGallery> figures, QWidget* parent)
    : QWidget(parent), gallery_(figures.release()) {
  gallery_->setParent(this);
  setObjectName("galleryPage");
  messages_ = new MessageBar;
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->setHandleWidth(1);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(makeLeft());
  splitter->addWidget(makeRight());
  splitter->setStretchFactor(0, 0);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({270, 1000});

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeHeading());
  column->addWidget(messages_);
  column->addWidget(splitter, 1);

  connect(list_, &FigureList::chosenChanged, this, &GalleryPage::showChosen);
  connect(list_, &FigureList::wanted, this, &GalleryPage::compute);
  connect(gallery_, &FigureGallery::changed, this, &GalleryPage::take);
  connect(picture_, &FigurePicture::failed, messages_, &MessageBar::showMessage);
  auto* escape =
      new QShortcut(Qt::Key_Escape, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
  connect(escape, &QShortcut::activated, this, &GalleryPage::closed);
  for (const FigureEntry& entry : figureEntries())
    list_->showStatus(entry.name, gallery_->status(entry.name));
  showChosen();
}

GalleryPage::~GalleryPage() = default;

std::unique_ptr<FigureGallery> GalleryPage::takeFigures() {
  gallery_->disconnect(this);
  gallery_->setParent(nullptr);
  return std::unique_ptr<FigureGallery>(gallery_);
}

GalleryState GalleryPage::state() const {
  GalleryState state{chosen(), claims_->unfolded(), realizations_->value(), {}};
  for (const QSplitter* splitter : findChildren<QSplitter*>())
    state.splits += splitter->saveState();
  return state;
}

void GalleryPage::setState(const GalleryState& state) {
  choose(state.figure, false);
  claims_->selectRow(state.claim);
  realizations_->setValue(state.realizations);
  const QList<QSplitter*> splitters = findChildren<QSplitter*>();
  for (qsizetype i = 0; i < splitters.size(); ++i)
    splitters[i]->restoreState(state.splits.value(i));
}

QWidget* GalleryPage::makeHeading() {
  auto* heading = new QWidget;
  heading->setObjectName("dockTitle");
  heading->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(heading);
  row->setContentsMargins(14, 5, 8, 5);
  row->addWidget(new QLabel(tr("Figures of the paper, computed here and now")), 1);
  auto* close = new QToolButton;
  close->setObjectName("closeGallery");
  close->setText(tr("✕"));
  close->setToolTip(tr("Back to the contact (Esc)"));
  close->setAccessibleName(tr("back to the contact"));
  close->setFocusPolicy(Qt::NoFocus);
  connect(close, &QToolButton::clicked, this, &GalleryPage::closed);
  row->addWidget(close);
  return heading;
}

QWidget* GalleryPage::makeLeft() {
  auto* left = new QWidget;
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  list_ = new FigureList;
  column->addWidget(list_, 1);
  column->addWidget(makeChoices());
  return left;
}

/// How many lines to average over, and all figures at once.
QWidget* GalleryPage::makeChoices() {
  auto* choices = new QWidget;
  choices->setObjectName("galleryBar");
  choices->setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(choices);
  column->setContentsMargins(12, 10, 12, 10);
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(tr("&Realizations"));
  realizations_ = new QSpinBox;
  realizations_->setObjectName("realizations");
  realizations_->setAccessibleName(tr("realizations to average over"));
  realizations_->setRange(1, kMostRealizations);
  realizations_->setValue(kQuick);
  label->setBuddy(realizations_);
  row->addWidget(label);
  row->addWidget(realizations_, 1);
  column->addLayout(row);
  auto* presets = new QHBoxLayout;
  presets->setSpacing(6);
  addButton(*presets, "quick", tr("&Quick"), tr("%1 realizations").arg(kQuick),
            &GalleryPage::chooseQuick);
  addButton(*presets, "paper", tr("Pap&er"), tr("%1 realizations, as in the paper").arg(kPaper),
            &GalleryPage::choosePaper);
  presets->addStretch(1);
  addButton(*presets, "computeAll", tr("Compute &all"), tr("All figures, one after another"),
            &GalleryPage::computeAll);
  column->addLayout(presets);
  return choices;
}

QWidget* GalleryPage::makeRight() {
  picture_ = new FigurePicture;
  claims_ = new ClaimsTable;
  auto* splitter = new QSplitter(Qt::Vertical);
  splitter->setHandleWidth(1);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(picture_);
  splitter->addWidget(claims_);
  splitter->setStretchFactor(0, 7);
  splitter->setStretchFactor(1, 3);
  splitter->setSizes({700, 300});

  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(splitter, 1);
  column->addWidget(makeCommands());
  return right;
}

QWidget* GalleryPage::makeCommands() {
  auto* commands = new QWidget;
  commands->setObjectName("galleryBar");
  commands->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(commands);
  row->setContentsMargins(12, 10, 12, 10);
  compute_ =
      addButton(*row, "compute", tr("&Compute"),
                tr("This figure, from lines made anew (Enter in the list)"), &GalleryPage::compute);
  cancel_ = addButton(*row, "cancel", tr("Ca&ncel"), tr("Ends what is computed and what waits"),
                      &GalleryPage::cancel);
  progress_ = new QProgressBar;
  progress_->setObjectName("figureProgress");
  progress_->setAccessibleName(tr("progress of the computation"));
  progress_->setRange(0, kSteps);
  row->addWidget(progress_, 1);
  note_ = new QLabel;
  note_->setObjectName("galleryNote");
  note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(note_, 1);
  openScene_ = addButton(*row, "openAsScene", tr("&Open as scene"),
                         tr("This figure's parameters in the window, to play with"),
                         &GalleryPage::openScene);
  savePicture_ = addButton(*row, "savePicture", tr("Save &picture…"), tr("PNG, SVG or PDF"),
                           &GalleryPage::askPicture);
  saveData_ = addButton(*row, "saveData", tr("Save &data…"),
                        tr("The table as CSV, or the claims as JSON"), &GalleryPage::askData);
  return commands;
}

QPushButton* GalleryPage::addButton(QLayout& row, const char* name, const QString& text,
                                    const QString& tip, void (GalleryPage::*run)()) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, this, run);
  row.addWidget(button);
  return button;
}

void GalleryPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  list_->setFocus();
}

void GalleryPage::setTheme(const Theme& theme) {
  setStyleSheet(galleryStyleSheet(paletteOf(theme)));
  picture_->setTheme(theme);
  claims_->setDark(isDark(theme));
}

FigureName GalleryPage::chosen() const {
  return list_->chosen();
}

void GalleryPage::take(FigureName name) {
  list_->showStatus(name, gallery_->status(name));
  if (name == chosen()) showChosen();
  showWork();
}

void GalleryPage::showChosen() {
  const FigureStatus& status = gallery_->status(chosen());
  if (!status.made)
    picture_->showText(status.work == FigureStage::None
                           ? tr("%1 is not computed yet.").arg(figureLabel(chosen()))
                           : tr("%1 appears here once it is computed.").arg(figureLabel(chosen())));
  if (status.made != shown_) showMade(status.made);
  status.error.isEmpty() ? messages_->hide() : messages_->showMessage(status.error);
  showWork();
}

void GalleryPage::showMade(std::shared_ptr<const MadeFigure> made) {
  shown_ = std::move(made);
  claims_->setClaims(shown_ ? shown_->figure.claims : std::vector<Claim>());
  if (shown_) picture_->showFigure(shown_);
  emit figureShown();
}

/// Which of the commands make sense now.
void GalleryPage::showWork() {
  const FigureStatus& status = gallery_->status(chosen());
  compute_->setText(status.made ? tr("&Compute again") : tr("&Compute"));
  compute_->setEnabled(status.work == FigureStage::None);
  for (QPushButton* button : {openScene_, savePicture_, saveData_})
    button->setEnabled(status.made != nullptr);
  const std::optional<FigureName> computing = gallery_->computing();
  cancel_->setVisible(computing.has_value());
  progress_->setVisible(computing.has_value());
  note_->setVisible(!computing);
  if (!computing) return;
  progress_->setValue(static_cast<int>(kSteps * gallery_->status(*computing).part));
  progress_->setFormat(figureLabel(*computing) + QStringLiteral(": %p %"));
}

}  // namespace asperity
