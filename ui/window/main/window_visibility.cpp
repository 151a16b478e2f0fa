#include "ui/window/main/window_visibility.h"

#include <QtGui/qguiapplication_platform.h>
#include <QEvent>
#include <QGuiApplication>
#include <QLibrary>
#include <QWidget>
#include <QWindow>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>

#if QT_CONFIG(xcb)
#include <xcb/xcb.h>
#endif

namespace asperity {

namespace {

#if QT_CONFIG(xcb)

/// Asks X11 for visibility events of a window, in addition to those that Qt asks for. The functions
/// come from the library that Qt's own plugin has loaded; on other window systems they are missing.
void askForVisibility(QWidget& window) {
  const auto* x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
  if (!x11 || !x11->connection())
    return;  // other platforms have the interface without a connection
  QLibrary library(QStringLiteral("xcb"), 1);
  // Only the types of the functions are named: the program is not linked with the library.
  const auto get = reinterpret_cast<decltype(&xcb_get_window_attributes)>(
      library.resolve("xcb_get_window_attributes"));
  const auto reply = reinterpret_cast<decltype(&xcb_get_window_attributes_reply)>(
      library.resolve("xcb_get_window_attributes_reply"));
  const auto change = reinterpret_cast<decltype(&xcb_change_window_attributes)>(
      library.resolve("xcb_change_window_attributes"));
  if (!get || !reply || !change) return;
  const auto id = static_cast<xcb_window_t>(window.winId());
  auto* attributes = reply(x11->connection(), get(x11->connection(), id), nullptr);
  if (!attributes) return;
  const std::uint32_t requested = attributes->your_event_mask | XCB_EVENT_MASK_VISIBILITY_CHANGE;
  std::free(attributes);
  change(x11->connection(), id, XCB_CW_EVENT_MASK, &requested);
}

/// Returns whether the window is fully covered, if the message reports that.
std::optional<bool> readCover(const QWindow& window, const QByteArray& type, const void* message) {
  if (type != "xcb_generic_event_t") return std::nullopt;
  const auto* event = static_cast<const xcb_visibility_notify_event_t*>(message);
  if ((event->response_type & 0x7f) != XCB_VISIBILITY_NOTIFY || event->window != window.winId())
    return std::nullopt;
  return event->state == XCB_VISIBILITY_FULLY_OBSCURED;
}

#else

void askForVisibility(QWidget&) {}

std::optional<bool> readCover(const QWindow&, const QByteArray&, const void*) {
  return std::nullopt;
}

#endif

}  // namespace

WindowVisibility::WindowVisibility(QWidget& window) : QObject(&window), window_(window) {
  window_.installEventFilter(this);
  qGuiApp->installNativeEventFilter(this);
  watchHandle();
}

WindowVisibility::~WindowVisibility() {
  qGuiApp->removeNativeEventFilter(this);
}

/// Watches the native window, which exists from the first showing on, and may be made again.
void WindowVisibility::watchHandle() {
  QWindow* handle = window_.windowHandle();
  if (!handle || !handle->handle()) return;
  if (handle != handle_) handle->installEventFilter(this);
  handle_ = handle;
  isCovered_ = false;
  askForVisibility(window_);
}

bool WindowVisibility::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::WinIdChange:
      watchHandle();
      break;
    case QEvent::Show:
      if (!handle_) watchHandle();
      break;
    case QEvent::Hide:
    case QEvent::Expose:
    case QEvent::WindowStateChange:
      // The check runs later, because the event has not had its effect yet.
      QMetaObject::invokeMethod(
          this, [this] { updateVisibility(); }, Qt::QueuedConnection);
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

bool WindowVisibility::nativeEventFilter(const QByteArray& type, void* message, qintptr*) {
  const std::optional<bool> isCovered = handle_ ? readCover(*handle_, type, message) : std::nullopt;
  if (!isCovered) return false;
  isCovered_ = *isCovered;
  updateVisibility();
  return false;
}

void WindowVisibility::updateVisibility() {
  const bool isVisible = window_.isVisible() && !window_.isMinimized() && handle_ &&
                         handle_->isExposed() && !isCovered_;
  if (std::exchange(isVisible_, isVisible) != isVisible) emit changed(isVisible);
}

}  // namespace asperity
