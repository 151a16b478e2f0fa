// The page on which a measured surface becomes the line of the scene: the interpretation of the
// file, which can be changed; each step from its heights to the line; the topography from above;
// the profile, its spectrum and its values before and after; and the notes that a user must know.
// It is updated after each change. Object names: those of ImportPage; "surfaceFacts",
// "surfaceValues", "surfaceNotes", "surfaceProfile", "surfaceSpectrum", "topographyPicture". GUI
// thread; deletes itself. Images may be made on any thread. Failure: one line on the page.
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "core/measured/topography.h"
#include "core/scene/scene.h"
#include "core/surface/measured_summary.h"
#include "ui/window/import/import_page.h"

namespace asperity {

class DiagramView;
class ParameterPanel;

struct TopographyImage {
  QImage image;                    // null: a single profile
  double width = 0, height = 0;    // m
  double lowest = 0, highest = 0;  // m, of the darkest and the brightest shade
  bool isTurned = false;           // the line runs from top to bottom
};

/// Makes an image of at most `maxPixels` pixels in each direction. Rows of the topography are rows
/// of the image, unless it was turned: then they are its columns, as in the file. The shades go
/// from the lowest to the highest percent of heights.
TopographyImage topographyImage(const Topography& topography, bool isTurned, int maxPixels = 512);

/// Shows heights as shades, points without a height left open, and the rows that become lines. The
/// widget keeps the proportions of the surface.
class TopographyPicture : public QWidget {
  Q_OBJECT

 public:
  explicit TopographyPicture(QWidget* parent = nullptr);

  /// Shows the image. `row`: the marked row, from 0 to 1 across the rows; below 0: all rows are
  /// used.
  void show(const TopographyImage& image, double row);

  QSize sizeHint() const override { return {170, 165}; }
  QSize minimumSizeHint() const override { return {140, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  TopographyImage shown_;
  double row_ = -1;
};

class SurfaceImport : public ImportPage {
  Q_OBJECT

 public:
  /// `scene`: receives the file as its surface; its choices for the same file stay.
  SurfaceImport(const Scene& scene, const QString& file, QWidget* parent = nullptr);

  ParameterPanel& panel() { return *panel_; }
  /// Returns what is shown of the present choices; nothing before, or where they are wrong.
  const std::optional<MeasuredSummary>& summary() const { return summary_; }

 signals:
  /// Emitted with the scene whose surface is the file, where the user accepts it.
  void sceneChosen(const asperity::Scene& scene);

 protected:
  void begin() override;

 private:
  struct Preview;
  void buildViews();
  void take(const Preview& preview);
  void showSummary(const MeasuredSummary& summary);

  Scene scene_;
  std::optional<MeasuredSummary> summary_;
  ParameterPanel* panel_;
  TopographyPicture* topography_;
  DiagramView *profile_, *spectrum_;
  QLabel *facts_, *values_, *notes_;
};

}  // namespace asperity
