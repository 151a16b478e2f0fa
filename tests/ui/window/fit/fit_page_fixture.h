// The main window with a measured friction, and the page that fits the scene to it. For tests on
// the GUI thread.
#pragma once

#include <QFile>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <vector>

#include "core/friction/steady_states.h"
#include "tests/ui/window/main_window_fixture.h"
#include "ui/window/curve/comparison_commands.h"
#include "ui/window/fit/fit_page.h"

namespace asperity {

class FitPageTest : public MainWindowTest {
 protected:
  /// The friction of the scene with another height and relaxation time, at these velocities.
  FitPageTest() {
    Scene truth = smallScene();
    truth.surface.rmsHeight *= 1.3;
    truth.elastomer.relaxationTime *= 2;
    std::vector<Scene> states;
    for (const double velocity : {1e-3, 1e-2, 0.1, 0.5, 2.0, 10.0, 50.0}) {
      states.push_back(truth);
      states.back().sliding.velocity = velocity;
    }
    const SteadyStates found = slideStates(states);
    QByteArray text = "velocity,mu,mu_error\n";
    for (std::size_t i = 0; i < states.size(); ++i)
      text += QByteArray::number(states[i].sliding.velocity) + "," +
              QByteArray::number(found.points[i].mu, 'g', 12) + "," +
              QByteArray::number(0.02 * found.points[i].mu, 'g', 6) + "\n";
    file_ = folder_.filePath("mine.csv");
    QFile file(file_);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }

  Scene withData() {
    Scene scene = smallScene();
    scene.comparison.data = {{file_.toStdString(), {}}};
    return scene;
  }
  const Scene& scene() { return window_.document().scene(); }

  FitPage& openPage(const Scene& scene) {
    window_.document().open(scene);
    return *window_.comparisons().openFit();
  }
  static int rowOf(QTableWidget& keys, const QString& key) {
    for (int row = 0; row < keys.rowCount(); ++row)
      if (keys.item(row, 0)->data(Qt::UserRole).toString() == key) return row;
    return -1;
  }
  static QTableWidget& keysOf(FitPage& page) { return *page.findChild<QTableWidget*>("fitKeys"); }
  static void tick(FitPage& page, const QString& key) {
    const int row = rowOf(keysOf(page), key);
    ASSERT_GE(row, 0) << key.toStdString();
    keysOf(page).item(row, 0)->setCheckState(Qt::Checked);
  }
  static QPushButton& button(FitPage& page, const char* name) {
    return *page.findChild<QPushButton*>(name);
  }
  bool fit(FitPage& page) {
    button(page, "fitRun").click();
    return waitFor([&] { return !page.isFitting(); });
  }

  QTemporaryDir folder_;
  QString file_;
};

}  // namespace asperity
