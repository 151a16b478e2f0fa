// What draws the contact: a frame is shown when its picture is ready, and every change is drawn.
#include "ui/window/contact/canvas_backend.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QSignalSpy>
#include <QTest>
#include <memory>
#include <vector>

#include "tests/ui/window/contact/contact_canvas_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/contact/contact_canvas.h"

namespace asperity {
namespace {

using CanvasBackendTest = ContactCanvasTest;

/// What changes with the frame is then painted together with its picture.
TEST_F(CanvasBackendTest, AFrameIsShownWhenItsPictureIsReady) {
  std::vector<std::shared_ptr<const Frame>> shown;
  QObject::connect(&canvas_, &ContactCanvas::frameShown, &canvas_,
                   [&](const std::shared_ptr<const Frame>& frame) { shown.push_back(frame); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return canvas_.framesPerSecond() > 0; }));
  shown.clear();
  const QImage before = canvas_.grab().toImage();
  const std::shared_ptr<const Frame> next = sampleContact(5);
  canvas_.setFrame(next);
  if (shown.empty()) {  // it is drawn in the background
    EXPECT_EQ(canvas_.grab().toImage(), before);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.empty(); }));
  EXPECT_NE(canvas_.grab().toImage(), before);
  canvas_.zoom(1);
  QTest::qWait(100);
  EXPECT_EQ(shown, std::vector{next}) << "another picture of the same frame";
}

/// Every change is drawn: sooner or later the picture is another one.
TEST_F(CanvasBackendTest, DrawsWhatIsChosen) {
  ASSERT_FALSE(canvas_.backendName().isEmpty());
  QSignalSpy painted(&canvas_, &ContactCanvas::painted);
  canvas_.setFrame(sampleContact());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !painted.empty(); }, 20000));
  const auto picture = [&] { return canvas_.grab().toImage(); };
  const auto differsFrom = [&](const QImage& before) {
    return QTest::qWaitFor([&] { return picture() != before; }, 20000);
  };
  const QImage plain = picture();
  action("magnify").trigger();
  ASSERT_TRUE(differsFrom(plain));
  const QImage magnified = picture();
  turnWheel(place(0.5, 0.4), 5);
  EXPECT_TRUE(differsFrom(magnified));
}

}  // namespace
}  // namespace asperity
