// The main window with a small scene, and a person in front of it. For tests on the GUI thread.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QDragEnterEvent>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <functional>

#include "tests/core/small_scene.h"
#include "ui/chart/chart_view.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"
#include "ui/panels/value_slider.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/exports.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"
#include "ui/window/main/tour.h"
#include "ui/window/main/window_layout.h"
#include "ui/window/main/window_pages.h"

namespace asperity {

inline constexpr int kWindowPatience = 20000;  // ms, far more than anything here takes

inline Scene smallScene() {
  Scene scene = sceneOfSize(256, 9, 3);
  scene.title = "small";
  return scene;
}

/// Returns a scene that is refused: a wave has too few elements.
inline Scene refusedScene() {
  Scene scene = smallScene();
  scene.surface.kind = SurfaceKind::Sine;
  scene.surface.waves = 8;
  scene.surface.elements = 10;
  return scene;
}

/// Opens a file in a window. Returns whether its scene is shown, once it is, or once a message
/// names the file or a question about it is answered.
inline bool openIn(
    MainWindow& window, const QString& file,
    const std::function<bool()>& isAnswered = [] { return false; }) {
  window.messages().hide();
  const QSignalSpy opened(&window.document(), &SceneDocument::opening);
  window.documentCommands().openFile(file);
  const auto isRefused = [&] {
    return !window.messages().isHidden() &&
           window.messages().text().contains(QFileInfo(file).fileName());
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return !opened.isEmpty() || isRefused() || isAnswered(); },
                              kWindowPatience));
  return !opened.isEmpty();
}

class MainWindowTest : public testing::Test {
 protected:
  MainWindowTest() : window_(smallScene()) {
    window_.panel().setView({true, {}});  // all rows
    window_.show();
    window_.activateWindow();
  }

  Session& session() { return window_.session(); }
  const Frame* frame() { return session().frame().get(); }
  /// The friction curve as it is shown.
  const Diagram& chart() { return window_.plotView().sheet().diagrams.front(); }

  template <class Condition>
  bool waitFor(Condition condition) {
    return QTest::qWaitFor(condition, kWindowPatience);
  }
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_, &drop);
  }
  bool open(const QString& file) {
    return openIn(window_, file, [this, before = asked_] { return asked_ != before; });
  }
  /// Saves the contact as it is shown. Returns whether the status line says so, or a message why
  /// not.
  bool savePicture(const QString& file) {
    window_.status().showMessage({});
    window_.exports().savePicture(file);
    const auto isSaved = [&] { return said() == "Saved " + QFileInfo(file).fileName(); };
    EXPECT_TRUE(waitFor([&] { return isSaved() || window_.messages().text().contains(file); }));
    return isSaved();
  }
  bool waitForFrame() {
    return waitFor([&] { return frame() && frame()->sceneNumber == session().sceneNumber(); });
  }

  /// Until the runner stands still, as it does when it is paused or nobody sees it. It obeys one
  /// order after the other: the answer to one shows that nothing before it goes on.
  bool waitForRest() {
    const auto answered = [this](bool slopes) {
      FrameFields fields = window_.canvas().fields();
      fields.lineSlope = slopes;
      session().requestFields(fields);
      return waitFor([&] { return frame() && frame()->lineSlope.empty() != slopes; });
    };
    const bool had = window_.canvas().fields().lineSlope;
    return answered(!had) && answered(had);
  }

  template <class Control>
  Control& control(const QString& name) {
    return *window_.findChild<Control*>(name);
  }
  void type(const QString& key, const QString& text) {
    auto& entry = control<ValueEntry>("entry:" + key);
    entry.setFocus();
    entry.selectAll();
    QTest::keyClicks(&entry, text);
    QTest::keyClick(&entry, Qt::Key_Return);
  }
  QAction& action(const QString& name) { return control<QAction>(name); }
  void press(const QString& key) {
    QTest::keyClick(&control<ValueSlider>("slider:" + key), Qt::Key_Right);
  }

  /// Answers the next question before what is not saved would be lost.
  void answer(QMessageBox::StandardButton button) {
    asked_ = 0;
    whenAsked<QMessageBox>([this, button](QMessageBox& box) {
      ++asked_;
      QTest::mouseClick(box.button(button), Qt::LeftButton);
    });
  }

  /// Calls `act` with the next modal dialog of this class, once it is there and takes keys. A later
  /// call replaces it. The dialog is closed where that takes too long, or it would wait for ever.
  template <class Dialog, class Act>
  void whenAsked(Act act) {
    const int turn = ++turn_;
    QElapsedTimer time;
    time.start();
    lookForDialog<Dialog>(std::move(act), turn, time);
  }
  int asked_ = 0;

  QString fact(const QString& name) { return control<QLabel>(name).text(); }
  QString said() { return fact("statusMessage"); }

  MainWindow window_;

 private:
  template <class Dialog, class Act>
  void lookForDialog(Act act, int turn, QElapsedTimer time) {
    QTimer::singleShot(10, &window_, [this, act = std::move(act), turn, time] {
      if (turn != turn_) return;
      auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      if (dialog && dialog->isActiveWindow()) return act(*dialog);
      if (time.elapsed() < kWindowPatience) return lookForDialog<Dialog>(act, turn, time);
      if (QWidget* other = QApplication::activeModalWidget()) {
        ADD_FAILURE() << other->objectName().toStdString() << " never became active";
        other->close();
      }
    });
  }

  int turn_ = 0;  // of whenAsked()
};

}  // namespace asperity
