#include "ui/window/fit/fit_page.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/input_error.h"
#include "core/chart/curve_set.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/ticks.h"
#include "ui/language/translated.h"
#include "ui/panels/labels.h"
#include "ui/panels/panel_style.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/fit/fit_results.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/window_keys.h"
#include "ui/window/main/window_layout.h"

namespace asperity {

namespace {

constexpr int kChoicesWidth = 342;  // pixels

enum Sheet { kCurve, kProfiles, kProgress };

QString askFolder(QWidget* parent, const QString& proposed) {
  const QString folder =
      QFileDialog::getExistingDirectory(parent, FitPage::tr("Folder of the report"), proposed);
  if (folder.isEmpty() || !QFileInfo::exists(QDir(folder).filePath("fit.json"))) return folder;
  const QString question =
      FitPage::tr("There is the report of another fit in this folder. Replace it?");
  return askReplace(parent, FitPage::tr("Save report"), question) ? folder : QString();
}

}  // namespace

FitPage::FitPage(const Scene& scene, const FitSelection& before, QWidget* parent)
    : QDialog(parent),
      scene_(scene),
      chooser_(askFolder),
      choices_(new FitChoices(scene, before)),
      run_(pageButton("fitRun", {}, this, &FitPage::pressRun)),
      save_(pageButton("fitSave", tr("&Save report…"), this, &FitPage::saveReport)),
      use_(pageButton("fitUse", tr("&Use these values"), this, &FitPage::useValues)),
      close_(pageButton("fitClose", tr("&Close"), this, &QDialog::reject)),
      table_(named<QLabel>("fitTable")),
      warnings_(warningTextLabel("fitWarnings")),
      notes_(named<QLabel>("fitNotes")),
      message_(errorTextLabel("fitComplaint")),
      progressText_(new QLabel),
      progress_(thinProgress("fitProgress")),
      sheets_(named<QTabBar>("fitSheets")),
      sheet_(named<DiagramView>("fitSheet")) {
  setObjectName("fitPage");
  setWindowTitle(tr("Fit to measured friction"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* left = new QVBoxLayout;
  left->addWidget(choices_, 1);
  left->addWidget(run_);
  choices_->setFixedWidth(std::max(kChoicesWidth, choices_->minimumSizeHint().width()));
  auto* halves = new QHBoxLayout;
  halves->setSpacing(14);
  halves->addLayout(left);
  auto* right = new QVBoxLayout;
  right->setSpacing(8);
  halves->addLayout(right, 1);
  buildResult();
  texts_ = new QWidget;
  auto* column = marginless<QVBoxLayout>(texts_);
  column->addWidget(table_);
  column->addWidget(warnings_);
  column->addWidget(notes_);
  column->addStretch(1);
  scroll_ = scrolled(texts_);
  scroll_->setAccessibleName(tr("values and notes of the fit"));
  right->addWidget(scroll_);
  right->addWidget(sheets_);
  right->addWidget(sheet_, 1);
  right->addStretch(0);  // below the notes, before there is a diagram
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(14, 12, 14, 12);
  all->addLayout(halves, 1);
  all->addLayout(foot());
  resizePage(*this, {1180, 760});
  connect(choices_, &FitChoices::changed, this, [this] {
    if (!isFitting()) finish(choices_->refusal());
  });
  connect(this, &QDialog::finished, this, [this] { work_.cancel(); });
  notes_->setText(
      tr("Tick the parameters to fit; type limits, which are optional, into “from” and “to”. Every "
         "trial uses the same random lines, and the weighted sum of the squared residuals is "
         "minimized. The best values appear here, "
         "and below them the curve with the points."));
  showState();
  showSheet();
}

void FitPage::buildResult() {
  notes_->setTextFormat(Qt::RichText);
  notes_->setWordWrap(true);
  for (QLabel* label : {table_, notes_}) {
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  table_->hide();
  warnings_->hide();
  sheets_->setDrawBase(false);
  sheets_->setExpanding(false);
  sheets_->addTab(tr("Curve"));
  sheets_->addTab(tr("Profiles"));
  sheets_->addTab(tr("Progress"));
  connect(sheets_, &QTabBar::currentChanged, this, &FitPage::showSheet);
  sheet_->setAccessibleName(tr("the fit as a diagram"));
  const auto fails = [this](const QString& reason) { finish(reason); };
  connect(sheet_, &DiagramView::failed, this, fails);
  connect(&sheet_->files(), &DiagramFiles::failed, this, fails);
}

QLayout* FitPage::foot() {
  message_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  progress_->setRange(0, 0);
  progress_->setAccessibleName(tr("progress of the fit"));
  auto* foot = new QHBoxLayout;
  foot->addWidget(message_, 1);
  foot->addWidget(progressText_);
  foot->addWidget(progress_);
  foot->addSpacing(8);
  foot->addWidget(close_);
  foot->addWidget(save_);
  foot->addWidget(use_);
  return foot;
}

QString FitPage::errorText() const {
  return message_->text();
}

void FitPage::pressRun() {
  if (isFitting())
    stop();
  else
    begin();
}

/// Begins a fit of the present choices; the earlier result stays until it has ended.
void FitPage::begin() {
  const QString refusal = choices_->refusal();
  if (!refusal.isEmpty()) return finish(refusal);
  const Scene scene = choices_->scene();
  const FitSelection selection = choices_->selection();
  std::vector<VariedParameter> varied;
  try {
    varied = variedParameters(selection, scene);
  } catch (const InputError& error) {
    return finish(errorWithLabel(error));
  }
  chiSquared_.clear();
  message_->clear();
  sheets_->setCurrentIndex(kProgress);
  work_.request(
      [this, scene, varied, texts = variedTexts(selection),
       hasProfiles = choices_->needsProfiles()](const BackgroundWork::Run& run) {
        FitOptions options;
        options.stop = run.stop();
        options.hasProfiles = hasProfiles;
        options.progress = [this, &run](int evaluations, double chiSquared) {
          run.post([this, evaluations, chiSquared] { showProgress(evaluations, chiSquared); });
        };
        auto fitted = std::make_shared<FittedCurve>(
            fitWithCurve(scene, readComparisonData(scene), varied, options));
        fitted->varied = texts;
        return fitted;
      },
      [this](const std::shared_ptr<FittedCurve>& fitted) { take(fitted); },
      [this](const QString& reason) { finish(reason); });
  showProgress(0, 0);
  showState();
}

/// Nothing of the stopped fit arrives later.
void FitPage::stop() {
  work_.cancel();
  finish(tr("The fit was stopped"), MessageKind::Note);
}

void FitPage::showProgress(int evaluations, double chiSquared) {
  if (evaluations > 0) chiSquared_.push_back(chiSquared);
  progressText_->setText(chiSquared_.empty()
                             ? tr("reading…")
                             : tr("evaluation %1, χ² = %2")
                                   .arg(evaluations)
                                   .arg(readingLabel(*std::ranges::min_element(chiSquared_))));
  if (sheets_->currentIndex() == kProgress) showSheet();
}

void FitPage::take(std::shared_ptr<const FittedCurve> fitted) {
  fitted_ = std::move(fitted);
  table_->setText(fittedTable(fitted_->fit, warningColour(palette())));
  table_->show();
  showWarnings(*warnings_, fitWarnings(fitted_->fit));
  notes_->setText(keptTogether(fittedNotes(fitted_->fit)));
  sheets_->setTabEnabled(kProfiles, !fitted_->fit.profiles.empty());
  giveTextsHeight();
  finish({});
  if (sheets_->currentIndex() == kProgress)
    sheets_->setCurrentIndex(kCurve);
  else
    showSheet();
}

/// Gives the texts the height that they need, up to a part of the page: the diagram takes the rest.
void FitPage::giveTextsHeight() {
  constexpr double kMax = 0.42;  // of the page
  const int needed = texts_->layout()->totalHeightForWidth(scroll_->width());
  scroll_->setFixedHeight(std::min(needed, static_cast<int>(kMax * height())));
}

void FitPage::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  layout()->activate();  // the texts have their width
  giveTextsHeight();
}

void FitPage::finish(const QString& text, MessageKind kind) {
  setMessage(*message_, text, kind);
  showState();
}

void FitPage::showState() {
  const bool isSaving = files_.isBusy();
  run_->setText(isFitting() ? tr("&Stop") : fitted_ ? tr("&Fit again") : tr("&Fit"));
  run_->setEnabled(isFitting() || choices_->isEnough());
  choices_->setEnabled(!isFitting());
  close_->setEnabled(!isSaving);
  for (QWidget* part : Widgets{progress_, progressText_}) part->setVisible(isFitting());
  for (QWidget* part : Widgets{sheets_, sheet_}) part->setVisible(isFitting() || fitted_);
  for (QPushButton* button : {save_, use_})
    button->setEnabled(fitted_ && !isFitting() && !isSaving);
}

void FitPage::showSheet() {
  if (sheets_->currentIndex() == kProgress)
    return sheet_->show([chiSquared = chiSquared_] { return progressSheet(chiSquared); });
  if (!fitted_) return sheet_->clear();
  const auto origin = [fitted = fitted_] { return pictureOrigin("fit", fitted->fit.scene); };
  if (sheets_->currentIndex() == kProfiles)
    sheet_->show([fitted = fitted_] { return profileSheet(fitted->fit); },
                 {"fit_profiles", origin, {}});
  else
    sheet_->show([fitted = fitted_] { return fitSheet(fitted->fit, fitted->set); },
                 {"fit_curve", origin, {}});
}

void FitPage::useValues() {
  if (!fitted_) return;
  emit valuesChosen(fitted_->fit);
  accept();
}

void FitPage::saveReport() {
  if (!fitted_) return;
  const QString folder = chooser_(this, QString::fromStdString(scene_.folder.string()));
  if (folder.isEmpty()) return;
  files_.request(
      [folder = folder.toStdString(), fitted = fitted_](const BackgroundWork::Run&) {
        return writeFitReport(folder, *fitted);
      },
      [this, folder](const QStringList& files) {
        finish(tr("Saved %1 files in %2").arg(files.size()).arg(QDir::toNativeSeparators(folder)),
               MessageKind::Note);
      },
      [this](const QString& reason) { finish(reason); });
  showState();
}

/// The page stays until its report is written: nobody would learn that it could not be.
void FitPage::reject() {
  if (!files_.isBusy()) QDialog::reject();
}

void FitPage::keyPressEvent(QKeyEvent* event) {
  if (!pressByReturn(*this, *event)) QDialog::keyPressEvent(event);
}

}  // namespace asperity
