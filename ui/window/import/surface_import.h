// The page on which a measured surface becomes the line of the scene: the interpretation of the
// file, which can be changed; each step from its heights to the line; the profile, its spectrum and
// its values before and after; and the notes that a user must know. It is updated after each
// change. Object names: those of ImportPage; "surfaceFacts", "surfaceValues", "surfaceNotes",
// "surfaceProfile", "surfaceSpectrum", "topographyPicture". GUI thread; deletes itself. Failure:
// one line on the page.
#pragma once

#include <optional>

#include "core/scene/scene.h"
#include "core/surface/measured_summary.h"
#include "ui/window/import/import_page.h"
#include "ui/window/import/topography_picture.h"

namespace asperity {

class DiagramView;
class ParameterPanel;

class SurfaceImport : public ImportPage {
  Q_OBJECT

 public:
  /// `scene`: receives the file as its surface; its choices for the same file stay.
  SurfaceImport(const Scene& scene, const QString& file, const Theme& theme,
                QWidget* parent = nullptr);

  ParameterPanel& panel() { return *panel_; }
  /// Returns what is shown of the present choices; nothing before, or where they are wrong.
  const std::optional<MeasuredSummary>& summary() const { return summary_; }

 signals:
  /// Emitted with the scene whose surface is the file, where the user accepts it.
  void sceneChosen(const asperity::Scene& scene);

 protected:
  void begin() override;
  BackgroundWork& work() override { return work_; }

 private:
  struct Preview;
  void buildViews(const Theme& theme);
  void take(const Preview& preview);
  void showSummary(const MeasuredSummary& summary);

  Scene scene_;
  std::optional<MeasuredSummary> summary_;
  ParameterPanel* panel_;
  TopographyPicture* topography_;
  DiagramView *profile_, *spectrum_;
  QLabel *facts_, *values_, *notes_;
  // Last: its thread ends before other members are destroyed.
  BackgroundWork work_{RequestPolicy::CancelRunning};
};

}  // namespace asperity
