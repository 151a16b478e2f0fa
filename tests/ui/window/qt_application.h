// A QApplication under the offscreen platform for a GoogleTest program: include in one source file.
// Made before the first test and gone after the last; the tests run on the GUI thread.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <memory>

#include "ui/window/main/run_window.h"

namespace asperity {

class QtApplication : public testing::Environment {
 public:
  void SetUp() override {
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + screens().toUtf8());
    for (const QSettings::Format format : {QSettings::NativeFormat, QSettings::IniFormat})
      QSettings::setPath(format, QSettings::UserScope, settings_.path());
    qputenv("XDG_CACHE_HOME", settings_.path().toUtf8());
    application_ = std::make_unique<QApplication>(count_, arguments_);
    prepareApplication(*application_);
  }
  void TearDown() override { application_.reset(); }

 private:
  /// The first is the platform's own; beside it a lecturer's projector, a small laptop and a large
  /// screen.
  QString screens() {
    QByteArray list;
    int left = 0;
    for (const QSize size : {QSize(800, 800), {1280, 720}, {1366, 768}, {2560, 1440}}) {
      const QString screen =
          QStringLiteral(R"({"name": "%4", "x": %3, "y": 0, "width": %1, "height": %2,
                            "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1})")
              .arg(size.width())
              .arg(size.height())
              .arg(left)
              .arg(left, 5, 10, QLatin1Char('0'));  // in the order of their names
      list += (list.isEmpty() ? "" : ", ") + screen.toUtf8();
      left += size.width();
    }
    QFile file(settings_.filePath("screens.json"));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"screens\": [" + list + "]}");
    return file.fileName();
  }

  QTemporaryDir settings_;  // never the user's own
  int count_ = 1;
  char name_[5] = "test";
  char* arguments_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

inline testing::Environment* const kQtApplication =
    testing::AddGlobalTestEnvironment(new QtApplication);

}  // namespace asperity
