// The main window with the page that imports a measured surface, and a person who uses it. For
// tests on the GUI thread.
#pragma once

#include <QAbstractButton>
#include <QComboBox>
#include <QFile>
#include <QPointer>
#include <QTemporaryDir>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/ui/window/main_window_fixture.h"
#include "ui/window/import/import_commands.h"
#include "ui/window/import/surface_import.h"

namespace asperity {

inline constexpr double kSineAmplitude = 2e-6;  // m
inline constexpr int kSinePoints = 400;

class SurfaceImportTest : public MainWindowTest {
 protected:
  QString write(const char* name, const std::string& text) {
    const QString path = folder_.filePath(name);
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text.c_str(), static_cast<qint64>(text.size()));
    return path;
  }

  /// Twenty waves of 50 um, in um over mm, on a tilted plane.
  QString sineFile(double tilt = 0, const char* header = "x [mm];z [µm]\n") {
    std::string text = header;
    for (int i = 0; i < kSinePoints; ++i) {
      const double x = i * 1e-3 / kSinePoints;  // m
      const double z =
          kSineAmplitude * std::sin(2 * std::numbers::pi * 20 * i / kSinePoints) + tilt * x;
      text += std::to_string(1e3 * x) + ";" + std::to_string(1e6 * z) + "\n";
    }
    return write("profile.csv", text);
  }

  SurfaceImport& openPage(const QString& file) {
    page_ = &window_.imports().openSurface(file);
    return *page_;
  }
  bool waitForPage() {
    return waitFor([&] { return page_ && !page_->isReading(); });
  }
  template <class Control>
  Control& inPage(const QString& name) {
    return *page_->findChild<Control*>(name);
  }
  void choose(const QString& key, const QString& word) {
    auto& box = inPage<QComboBox>("choice:" + key);
    box.setCurrentIndex(box.findData(word));
    emit box.activated(box.currentIndex());
  }
  void click(const QString& name) {
    QTest::mouseClick(&inPage<QAbstractButton>(name), Qt::LeftButton);
  }
  const Scene& scene() { return window_.document().scene(); }

  QTemporaryDir folder_;
  QPointer<SurfaceImport> page_;
};

}  // namespace asperity
