// The canvas of the contact with a frame of a rough line, driven as by hands. For tests on the GUI
// thread.
#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <QTest>
#include <QWheelEvent>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/run/steady_frames.h"
#include "tests/ui/window/window_in.h"
#include "ui/contact/contact_signs.h"
#include "ui/window/contact/contact_canvas.h"

namespace asperity {

inline std::shared_ptr<const Frame> sampleContact(std::int64_t index = 0) {
  Scene scene;
  scene.surface.elements = 500;
  scene.load.normalForce = 0.1;
  static const SteadyFrames frames(std::make_shared<const Scene>(scene));
  return std::make_shared<const Frame>(frames.frame(index, 60, 25));
}

class ContactCanvasTest : public testing::Test {
 protected:
  void SetUp() override {
    canvas_.resize(900, 500);
    addContactViewActions(canvas_, menu_);
    canvas_.setFrame(sampleContact());
    canvas_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas_));
  }

  ContactView view() const { return canvas_.viewer().options().view; }

  QPointF place(double x, double y) const {
    const QRectF plot = canvas_.plotArea();
    return {plot.left() + x * plot.width(), plot.bottom() - y * plot.height()};
  }

  void turnWheel(QPointF at, int steps, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(at, canvas_.mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas_, &event);
  }

  QAction& action(const char* name) { return *canvas_.findChild<QAction*>(name); }

  ContactCanvas canvas_;
  QMenu menu_;
};

/// The same with a scene, which drags change.
class DraggedCanvasTest : public ContactCanvasTest {
 protected:
  void SetUp() override {
    ContactCanvasTest::SetUp();
    scene_ = *sampleContact()->scene;
    canvas_.setScene(scene_);
    QObject::connect(&canvas_, &ContactCanvas::sceneEdited, &canvas_, [this](const Scene& scene) {
      scene_ = scene;
      ++edits_;
      canvas_.setScene(scene);
    });
  }

  /// The middle of the label or arrow that changes this.
  QPoint handle(ContactHandle wanted) {
    const std::optional<QPoint> place = handleIn(canvas_, wanted);
    EXPECT_TRUE(place) << "no handle";
    return place.value_or(QPoint());
  }

  void drag(QPoint from, QPoint by) {
    QTest::mouseMove(&canvas_, from);
    QTest::mousePress(&canvas_, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&canvas_, from + by * i / 4);
  }
  void drop(QPoint at) { QTest::mouseRelease(&canvas_, Qt::LeftButton, {}, at); }

  Scene scene_;
  int edits_ = 0;
};

}  // namespace asperity
