#include "ui/window/accuracy/region_pictures.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "ui/language/explained.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/figures/figure_picture.h"

namespace asperity {

namespace {

constexpr float kMinText = 0.9F;  // the view is low, which would make its texts small

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
      bar_(new QWidget),
      buttons_(new QButtonGroup(this)),
      range_(new QLabel),
      picture_(new FigurePicture) {
  setAttribute(Qt::WA_StyledBackground);
  setObjectName("regionPictures");
  bar_->setObjectName("regionBar");
  places_ = new QHBoxLayout(bar_);
  places_->setContentsMargins(14, 5, 14, 0);
  places_->setSpacing(4);
  places_->addStretch(1);
  range_->setObjectName("regionRange");
  places_->addWidget(range_);
  buttons_->setExclusive(true);
  connect(buttons_, &QButtonGroup::idClicked, this, &RegionPictures::choose);
  picture_->setMinimumSize(200, 100);
  picture_->setMinTextSize(kMinText);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
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
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("region:%1").arg(i));
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
