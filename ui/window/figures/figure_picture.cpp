#include "ui/window/figures/figure_picture.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <utility>

#include "ui/chart/chart_panel.h"
#include "ui/chart/figure_drawing.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/main/appearance.h"

namespace asperity {

FigurePicture::FigurePicture(QWidget* parent) : QWidget(parent) {
  setObjectName("figurePicture");
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FigurePicture::showFigure(std::shared_ptr<const ComputedFigure> made) {
  if (made == figure_) return;
  figure_ = std::move(made);
  describe();
  pictures_.cancel();
  requestPicture();
}

void FigurePicture::describe() {
  setAccessibleName(translatedText(figure_->figure.sheet.title));
  setAccessibleDescription(translatedText(figure_->figure.sheet.note));
}

void FigurePicture::showText(const QString& text) {
  pictures_.cancel();
  figure_.reset();
  image_ = {};
  text_ = text;
  setAccessibleName(text);
  setAccessibleDescription({});
  update();
}

void FigurePicture::setTheme(const Theme& theme) {
  theme_ = theme;
  requestPicture();
  update();
}

void FigurePicture::setMinTextSize(float part) {
  minTextSize_ = part;
  requestPicture();
}

bool FigurePicture::isPainted() const {
  return figure_ && shown_ == asked_ && image_.size() == size() * devicePixelRatioF();
}

void FigurePicture::requestPicture() {
  if (!figure_ || size().isEmpty()) return;
  const double scale = devicePixelRatioF();
  const QSize pixels = size() * scale;
  DiagramOptions options{pixels.width(), pixels.height(),
                         static_cast<float>(scale * markScale(font())), theme_, minTextSize_};
  ++asked_;
  pictures_.request(
      [made = figure_, options, scale](const BackgroundWork::Run&) {
        QImage image = renderImage(contextOfThread(),
                                   composeFigure(made->figure, made->contact.get(), options));
        image.setDevicePixelRatio(scale);
        return image;
      },
      [this, number = asked_](const QImage& image) {
        shown_ = number;
        image_ = image;
        update();
        emit painted();
      },
      [this](const LiveText& reason) { emit failed(reason); });
}

/// The texts of the picture have the font and language of the window.
void FigurePicture::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange && figure_) describe();
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange)
    requestPicture();
}

void FigurePicture::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  requestPicture();
}

/// Stretches the last picture until one of the new size is ready.
void FigurePicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!image_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), image_);
    return;
  }
  painter.fillRect(rect(), toQColor(theme_.background));
  painter.setPen(toQColor(theme_.faintText));
  if (!figure_)
    painter.drawText(rect().adjusted(40, 20, -40, -20), Qt::AlignCenter | Qt::TextWordWrap, text_);
}

// ---- One diagram at a time

namespace {

constexpr float kMinRegionText = 0.9F;  // the view is low, which would make its texts small

/// Splits a title: "region I" and "1 to 2 m/s" of "region I: 1 to 2 m/s".
std::pair<QString, QString> splitTitle(const Diagram& diagram) {
  const QString title = translatedText(diagram.title);
  const qsizetype colon = title.indexOf(QStringLiteral(": "));
  if (colon < 0) return {title, {}};
  return {title.left(colon), title.mid(colon + 2)};
}

/// Returns one diagram without the texts above and below it: the buttons have the names, the
/// tooltip has the note.
std::shared_ptr<const ComputedFigure> singleDiagram(const ComputedFigure& made, std::size_t index) {
  auto one = std::make_shared<ComputedFigure>();
  one->figure.scene = made.figure.scene;
  const DiagramSheet& sheet = made.figure.sheet;
  one->figure.sheet.diagrams = {sheet.diagrams[index]};
  one->figure.sheet.diagrams.front().title = {};
  return one;
}

}  // namespace

RegionPictures::RegionPictures(QWidget* parent)
    : QWidget(parent),
      bar_(named<QWidget>("regionBar")),
      buttons_(new QButtonGroup(this)),
      range_(named<QLabel>("regionRange")),
      picture_(new FigurePicture) {
  setAttribute(Qt::WA_StyledBackground);
  setObjectName("regionPictures");
  places_ = new QHBoxLayout(bar_);
  places_->setContentsMargins(14, 5, 14, 0);
  places_->setSpacing(4);
  places_->addStretch(1);
  places_->addWidget(range_);
  buttons_->setExclusive(true);
  connect(buttons_, &QButtonGroup::idClicked, this, &RegionPictures::choose);
  picture_->setMinimumSize(200, 100);
  picture_->setMinTextSize(kMinRegionText);
  auto* column = marginless<QVBoxLayout>(this, 0);
  column->addWidget(bar_);
  column->addWidget(picture_, 1);
  bar_->hide();
  keepTranslated(*this, [this] {
    if (!figure_) return;
    const int shown = chosen();
    showFigure(figure_);
    choose(shown);
  });
}

void RegionPictures::showText(const QString& text) {
  figure_.reset();
  bar_->hide();
  picture_->setToolTip({});
  picture_->showText(text);
}

void RegionPictures::showFigure(std::shared_ptr<const ComputedFigure> made) {
  figure_ = std::move(made);
  clearButtons();
  const std::vector<Diagram>& diagrams = figure_->figure.sheet.diagrams;
  int chosen = 0;
  for (int i = 0; i < static_cast<int>(diagrams.size()); ++i) {
    const auto [name, range] = splitTitle(diagrams[static_cast<std::size_t>(i)]);
    auto* button = named<QToolButton>(QStringLiteral("region:%1").arg(i));
    button->setText(name);
    button->setToolTip(range);
    button->setAccessibleName(range.isEmpty() ? name : name + ", " + range);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    buttons_->addButton(button, i);
    places_->insertWidget(i, button);
    if (name == chosen_) chosen = i;
  }
  bar_->setVisible(!diagrams.empty());
  if (!diagrams.empty()) choose(chosen);
}

void RegionPictures::setTheme(const Theme& theme) {
  picture_->setTheme(theme);
}

void RegionPictures::clearButtons() {
  for (QAbstractButton* button : buttons_->buttons()) delete button;
}

int RegionPictures::chosen() const {
  return buttons_->checkedId();
}

void RegionPictures::choose(int index) {
  if (!buttons_->button(index)) return;
  const auto position = static_cast<std::size_t>(index);
  const auto [name, range] = splitTitle(figure_->figure.sheet.diagrams.at(position));
  chosen_ = name;
  range_->setText(range);
  buttons_->button(index)->setChecked(true);
  picture_->showFigure(singleDiagram(*figure_, position));
  const DiagramSheet& sheet = figure_->figure.sheet;
  picture_->setAccessibleName(translatedText(sheet.title) + ", " + name);
  picture_->setAccessibleDescription(translatedText(sheet.note));
  picture_->setToolTip(wrappedTip(translatedText(sheet.note)));
}

}  // namespace asperity
