// An application that measures what each event costs the window's thread: in time of its processor,
// because the machine may have other work.
#pragma once

#include <QApplication>
#include <QEvent>
#include <QMetaEnum>
#include <QString>
#include <vector>

#include "core/base/jobs.h"

namespace asperity {

/// An event that kept the thread busy.
struct BusyEvent {
  double seconds = 0;  // of the processor
  QString name{};      // "MetaCall to asperity::BackgroundWork"
};

class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  /// The events that took at least so long, since the last call.
  std::vector<BusyEvent> takeBusy(double seconds) {
    std::vector<BusyEvent> busy;
    for (BusyEvent& event : events_)
      if (event.seconds >= seconds) busy.push_back(std::move(event));
    events_.clear();
    return busy;
  }

  bool notify(QObject* receiver, QEvent* event) override {
    if (depth_ > 0) return QApplication::notify(receiver, event);
    // The receiver may be gone afterwards.
    const QString name =
        QStringLiteral("%1 to %2 %3")
            .arg(QString::fromLatin1(QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type())),
                 QString::fromLatin1(receiver->metaObject()->className()), receiver->objectName());
    ++depth_;
    const double begin = threadSeconds();
    const bool isDone = QApplication::notify(receiver, event);
    const double spent = threadSeconds() - begin;
    --depth_;
    constexpr double kNegligible = 1e-3;
    if (spent >= kNegligible) events_.push_back({spent, name});
    return isDone;
  }

 private:
  int depth_ = 0;
  std::vector<BusyEvent> events_;
};

}  // namespace asperity
