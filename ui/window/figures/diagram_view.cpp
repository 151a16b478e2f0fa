#include "ui/window/figures/diagram_view.h"

#include <QContextMenuEvent>
#include <QEvent>
#include <QMenu>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/input_error.h"
#include "ui/chart/chart_style.h"
#include "ui/chart/diagram_axes.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/language/translated.h"
#include "ui/window/main/appearance.h"

namespace asperity {

namespace {

constexpr int kPicturePause = 400;  // ms between two pictures

DiagramSheet makeSheet(const DiagramMaker& maker) {
  try {
    return maker();
  } catch (const std::exception& error) {
    DiagramSheet sheet;
    sheet.title = errorMessage(error);
    return sheet;
  }
}

}  // namespace

DiagramSheet readableSheet(DiagramSheet sheet, const DiagramOptions& options) {
  constexpr float kLowest = 6;       // in heights of the numbers
  constexpr float kNarrowest = 190;  // logical pixels of one diagram
  const auto isLow = [&] { return lowestFrame(sheet, options) < kLowest; };
  if (sheet.columns != 1 || sheet.diagrams.size() < 2 || !isLow()) return sheet;
  const auto available =
      static_cast<std::size_t>(static_cast<float>(options.width) / (kNarrowest * options.scale));
  sheet.diagrams.resize(std::clamp<std::size_t>(available, 1, sheet.diagrams.size()));
  sheet.columns = static_cast<int>(sheet.diagrams.size());
  sheet.sharesAxis = false;
  sheet = translated(std::move(sheet));
  for (Diagram& diagram : sheet.diagrams) {
    diagram.height = 1;
    for (DiagramSeries& series : diagram.series)
      if (const std::string symbol = trailingSymbol(series.name.text); !symbol.empty())
        series.name = Message::name(symbol);
  }
  if (!sheet.subtitle.empty()) sheet.title = {};
  if (isLow()) sheet.note = {};
  return sheet;
}

DiagramView::DiagramView(QWidget* parent)
    : QWidget(parent), files_(new DiagramFiles(*this)), pause_(new QTimer(this)) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  pause_->setSingleShot(true);
  pause_->setInterval(kPicturePause);
  connect(pause_, &QTimer::timeout, this, [this] {
    if (isDue_) request();
  });
}

void DiagramView::show(const DiagramMaker& maker, DiagramExport saved) {
  compose_ = [maker](const DiagramOptions& options) {
    const DiagramSheet sheet = readableSheet(makeSheet(maker), options);
    return Picture{composeDiagrams(sheet, options), diagramFrames(sheet, options)};
  };
  if (!saved.sheet) saved.sheet = maker;
  files_->setDiagram(std::move(saved));
  // The menu with which it is saved opens by a key, too.
  if (!files_->isEmpty()) setFocusPolicy(Qt::StrongFocus);
  requestSoon();
}

void DiagramView::showPicture(Composer composer) {
  pictures_.cancel();
  files_->setDiagram({});
  placeholder_.clear();
  compose_ = [draw = std::move(composer)](const DiagramOptions& options) {
    return Picture{draw(options)};
  };
  requestSoon();
}

void DiagramView::clear() {
  pictures_.cancel();
  files_->setDiagram({});
  compose_ = {};
  take({}, {});
}

void DiagramView::showText(const QString& text) {
  clear();
  setPlaceholder(text);
  setAccessibleName(text);
  setAccessibleDescription({});
}

void DiagramView::take(const QImage& image, const std::vector<ChartGeometry>& frames) {
  image_ = image;
  frames_ = frames;
  update();
}

void DiagramView::setPlaceholder(const QString& text) {
  if (text == placeholder_) return;
  placeholder_ = text;
  update();
}

const Theme& DiagramView::theme() const {
  return pictureTheme(palette());
}

void DiagramView::setPause(int pause) {
  pause_->setInterval(pause);
}

void DiagramView::setMinTextSize(float part) {
  minTextSize_ = part;
  requestSoon();
}

void DiagramView::requestSoon() {
  isDue_ = true;
  if (!pause_->isActive()) request();
}

/// Requests a picture. A hidden view waits until it is visible.
void DiagramView::request() {
  if (!isVisible() || !compose_ || size().isEmpty()) return;
  isDue_ = false;
  pause_->start();
  const double scale = devicePixelRatioF();
  const QSize pixels = size() * scale;
  const DiagramOptions options{pixels.width(), pixels.height(),
                               static_cast<float>(scale * markScale(font())), theme(),
                               minTextSize_};
  pictures_.request(
      [compose = compose_, options, scale](const BackgroundWork::Run&) {
        Picture picture = compose(options);
        QImage image = renderImage(contextOfThread(), picture.list);
        image.setDevicePixelRatio(scale);
        for (ChartGeometry& frame : picture.frames)
          frame.area = {frame.area.topLeft() / scale, frame.area.size() / scale};
        return std::pair{image, std::move(picture.frames)};
      },
      [this](const std::pair<QImage, std::vector<ChartGeometry>>& made) {
        take(made.first, made.second);
      },
      [this](const LiveText& reason) {
        take({}, {});  // the picture before shows something else
        emit failed(reason);
      });
}

void DiagramView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit visibilityChanged(true);
  requestSoon();
}

void DiagramView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit visibilityChanged(false);
}

void DiagramView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  requestSoon();
}

/// The picture has the colours of the window, and its texts the font and the language.
void DiagramView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange ||
      event->type() == QEvent::PaletteChange)
    requestSoon();
}

void DiagramView::contextMenuEvent(QContextMenuEvent* event) {
  if (files_->isEmpty()) return QWidget::contextMenuEvent(event);
  QMenu::exec(files_->actions(), event->globalPos(), nullptr, this);
}

bool DiagramView::hasFrame() const {
  return std::ranges::any_of(frames_,
                             [](const ChartGeometry& frame) { return frame.area.width() > 0; });
}

/// Stretches the last picture until one of the new size is ready.
void DiagramView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), toQColor(theme().background));
  if (!hasFrame() && !placeholder_.isEmpty()) {
    painter.setPen(toQColor(theme().faintText));
    return painter.drawText(rect().adjusted(40, 20, -40, -20), Qt::AlignCenter | Qt::TextWordWrap,
                            placeholder_);
  }
  if (image_.isNull()) return;
  painter.setRenderHint(QPainter::SmoothPixmapTransform,
                        image_.size() != size() * devicePixelRatioF());
  painter.drawImage(rect(), image_);
  if (!hasFocus()) return;
  painter.setPen(palette().color(QPalette::Highlight));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace asperity
