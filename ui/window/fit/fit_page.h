// The page on which parameters of the scene are fitted to the measured friction that it names:
// what is varied and within which limits; the fit in the background with its progress, which can be
// stopped at once; best values with errors and correlations, the fitted curve with its band, and
// the profile of the sum of squares along each parameter. The values become those of the scene, or
// a report is written as `asperity fit` writes it. Object names: those of FitChoices; "fitRun",
// "fitTable", "fitWarnings", "fitNotes", "fitSheets", "fitSheet", "fitProgress", "fitComplaint",
// "fitSave", "fitUse", "fitClose". GUI thread; deletes itself. Failure: one line on the page.
#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "core/chart/fit_report.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/window/fit/fit_choices.h"
#include "ui/window/tasks/background_work.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTabBar;

namespace asperity {

class DiagramView;

class FitPage : public QDialog {
  Q_OBJECT

 public:
  FitPage(const Scene& scene, const FitSelection& before, QWidget* parent = nullptr);

  FitChoices& choices() { return *choices_; }
  /// Returns what is shown; null before the first fit has ended.
  const FittedCurve* fitted() const { return fitted_.get(); }
  bool isFitting() const { return work_.isBusy(); }
  /// Returns the error message, or the note in its place; empty without either.
  QString errorText() const;

  /// Replaces the usual dialog.
  void setFolderChooser(FileChooser chooser) { chooser_ = std::move(chooser); }

 signals:
  /// Emitted where the user takes the fitted values; the page closes then.
  void valuesChosen(const asperity::Fit& fit);

 protected:
  void reject() override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildResult();
  QLayout* foot();
  void pressRun();
  void begin();
  void stop();
  void showProgress(int evaluations, double chiSquared);
  void take(std::shared_ptr<const FittedCurve> fitted);
  void giveTextsHeight();
  void finish(const QString& text, MessageKind kind = MessageKind::Error);
  void showState();
  void showSheet();
  void useValues();
  void saveReport();

  Scene scene_;
  FileChooser chooser_;
  std::shared_ptr<const FittedCurve> fitted_;
  std::vector<double> chiSquared_;  // of each evaluation so far
  FitChoices* choices_;
  QPushButton *run_, *save_, *use_, *close_;
  QLabel *table_, *warnings_, *notes_, *message_, *progressText_;
  QProgressBar* progress_;
  QWidget* texts_ = nullptr;  // values and notes, within `scroll_`
  QScrollArea* scroll_ = nullptr;
  QTabBar* sheets_;
  DiagramView* sheet_;
  // Last: their threads end before other members are destroyed.
  BackgroundWork files_{RequestPolicy::RunInOrder};
  BackgroundWork work_{RequestPolicy::CancelRunning};
};

}  // namespace asperity
