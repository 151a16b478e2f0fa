// A measured topography seen from above: heights as shades, points without a height left open, and
// the rows that become lines. The widget keeps the proportions of the surface. GUI thread; belongs
// to its parent. Images may be made on any thread.
#pragma once

#include <QImage>
#include <QWidget>

#include "core/measured/topography.h"

namespace asperity {

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

}  // namespace asperity
