#include "ui/window/main/contact_canvas.h"

#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "ui/draw/fonts.h"
#include "ui/window/main/canvas_backend.h"

namespace asperity {

namespace {

bool prefersOpenGl() {
  const QString wish = qEnvironmentVariable("ASPERITY_CANVAS");
  if (wish == QStringLiteral("software")) return false;
  const OpenGlSupport support = openGlSupport();
  if (wish == QStringLiteral("opengl")) return support != OpenGlSupport::None;
  return support == OpenGlSupport::Hardware;
}

}  // namespace

ContactCanvas::ContactCanvas(QWidget* parent)
    : QWidget(parent), layout_(new QVBoxLayout(this)), veil_(new QLabel(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  setMinimumSize(320, 160);
  setAccessibleName(tr("contact view"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  grabGesture(Qt::PinchGesture);
  veil_->setObjectName("contactVeil");
  veil_->setAlignment(Qt::AlignCenter);
  veil_->setWordWrap(true);
  veil_->setAttribute(Qt::WA_TransparentForMouseEvents);
  veil_->hide();
  clock_.start();
  prefersOpenGl() ? useOpenGl() : useSoftware();
}

void ContactCanvas::setFrame(std::shared_ptr<const Frame> frame) {
  viewer_.setFrame(std::move(frame));
  refresh();
}

void ContactCanvas::setTheme(const Theme& theme) {
  theme_ = theme;
  paintVeil();
  refresh();
}

void ContactCanvas::setVeil(const QString& reason) {
  veil_->setText(reason);
  veil_->setVisible(!reason.isEmpty());
}

/// As the background, and half of the picture shines through.
void ContactCanvas::paintVeil() {
  QColor background = colourOf(theme_.background);
  background.setAlphaF(0.7F);
  veil_->setStyleSheet(QStringLiteral("QLabel { background: %1; color: %2; }")
                           .arg(background.name(QColor::HexArgb), colourOf(theme_.text).name()));
}

void ContactCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  veil_->setGeometry(rect());
}

void ContactCanvas::setTextScale(double scale) {
  textScale_ = scale;
  refresh();
}

QString ContactCanvas::backendName() const {
  return backend_ ? backend_->name() : QString();
}

int ContactCanvas::framesPerSecond() const {
  while (!pictures_.empty() && pictures_.front() < clock_.elapsed() - 1000) pictures_.pop_front();
  return static_cast<int>(pictures_.size());
}

void ContactCanvas::useOpenGl() {
  CanvasEvents events;
  events.painted = [this] { countPicture(); };
  events.failed = [this](const QString&) { useSoftware(); };
  place(makeOpenGlCanvas(std::move(events), this));
}

void ContactCanvas::useSoftware() {
  CanvasEvents events;
  events.painted = [this] { countPicture(); };
  events.failed = [this](const QString& reason) { giveUp(reason); };
  place(makeSoftwareCanvas(std::move(events), this));
}

void ContactCanvas::place(CanvasBackend* backend) {
  if (backend_) {
    backend_->widget()->hide();
    backend_->widget()->deleteLater();
  }
  backend_ = backend;
  backend_->widget()->setAttribute(Qt::WA_TransparentForMouseEvents);  // they are this widget's
  layout_->addWidget(backend_->widget());
  veil_->raise();
  refresh();
}

void ContactCanvas::giveUp(const QString& reason) {
  backend_->widget()->hide();
  backend_->widget()->deleteLater();
  backend_ = nullptr;
  auto* label = new QLabel(tr("The contact cannot be drawn here: %1").arg(reason));
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  layout_->addWidget(label);
  emit failed(reason);
}

void ContactCanvas::countPicture() {
  pictures_.push_back(clock_.elapsed());
  emit painted();
}

void ContactCanvas::refresh() {
  if (backend_ && viewer_.frame()) backend_->show(request());
}

/// What is on the screen: the backend fills this widget.
PictureRequest ContactCanvas::request() const {
  PictureRequest request;
  request.frame = viewer_.frame();
  request.options = viewer_.options();
  request.options.theme = theme_;
  request.textScale = textScale_;
  request.scale = devicePixelRatioF();
  request.size = size() * request.scale;
  return request;
}

}  // namespace asperity
