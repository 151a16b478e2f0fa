// One QGuiApplication without a display for all tests of this program.
#include <gtest/gtest.h>

#include <QGuiApplication>
#include <memory>

#include "ui/draw/fonts.h"

namespace asperity {
namespace {

class QtEnvironment : public testing::Environment {
 public:
  void SetUp() override {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    application_ = std::make_unique<QGuiApplication>(argc_, argv_);
    loadFonts();
  }
  void TearDown() override { application_.reset(); }

 private:
  char name_[5] = "test";
  char* argv_[2] = {name_, nullptr};
  int argc_ = 1;
  std::unique_ptr<QGuiApplication> application_;
};

const testing::Environment* const kQt = testing::AddGlobalTestEnvironment(new QtEnvironment);

}  // namespace
}  // namespace asperity
