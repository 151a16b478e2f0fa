// Numbers the gestures of a person: a press of a button or of a key begins a new one; what moves,
// repeats and turns meanwhile belongs to it. Watches the whole application. GUI thread.
#pragma once

#include <QObject>
#include <cstdint>

namespace asperity {

class GestureCounter : public QObject {
 public:
  explicit GestureCounter(QObject* parent = nullptr);

  std::uint64_t present() const { return present_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::uint64_t present_ = 0;
  bool isTurning_ = false;  // the wheel
};

}  // namespace asperity
