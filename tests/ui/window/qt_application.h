// A QApplication under the offscreen platform for a GoogleTest program: include in one source file.
// Made before the first test and gone after the last; the tests run on the GUI thread.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <memory>

#include "ui/window/run_window.h"

namespace asperity {

class QtApplication : public testing::Environment {
 public:
  void SetUp() override {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    for (const QSettings::Format format : {QSettings::NativeFormat, QSettings::IniFormat})
      QSettings::setPath(format, QSettings::UserScope, settings_.path());
    application_ = std::make_unique<QApplication>(count_, arguments_);
    prepareApplication(*application_);
  }
  void TearDown() override { application_.reset(); }

 private:
  QTemporaryDir settings_;  // never the user's own
  int count_ = 1;
  char name_[5] = "test";
  char* arguments_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

inline testing::Environment* const kQtApplication =
    testing::AddGlobalTestEnvironment(new QtApplication);

}  // namespace asperity
