#include "ui/window/accuracy/region_pictures.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <utility>
#include <vector>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/figures/diagram_view.h"

namespace asperity {

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
DiagramSheet singleDiagram(Diagram diagram) {
  diagram.title = {};
  return {.diagrams = {std::move(diagram)}};
}

}  // namespace

RegionPictures::RegionPictures(QWidget* parent)
    : QWidget(parent),
      bar_(named<QWidget>("regionBar")),
      buttons_(new QButtonGroup(this)),
      range_(named<QLabel>("regionRange")),
      picture_(named<DiagramView>("figurePicture")) {
  setAttribute(Qt::WA_StyledBackground);
  setObjectName("regionPictures");
  places_ = new QHBoxLayout(bar_);
  places_->setContentsMargins(14, 5, 14, 0);
  places_->setSpacing(4);
  places_->addStretch(1);
  places_->addWidget(range_);
  connect(buttons_, &QButtonGroup::idClicked, this, &RegionPictures::choose);
  picture_->setMinimumSize(200, 100);
  picture_->setPause(0);
  picture_->setMinTextSize(kMinRegionText);
  auto* column = marginless<QVBoxLayout>(this, 0);
  column->addWidget(bar_);
  column->addWidget(picture_, 1);
  bar_->hide();
  keepTranslated(*this, [this] {
    if (!sheet_) return;
    const int shown = buttons_->checkedId();
    showSheet(*sheet_);
    choose(shown);
  });
}

void RegionPictures::showText(const QString& text) {
  sheet_.reset();
  bar_->hide();
  picture_->setToolTip({});
  picture_->showText(text);
}

void RegionPictures::showSheet(DiagramSheet sheet) {
  sheet_ = std::move(sheet);
  const std::vector<Diagram>& diagrams = sheet_->diagrams;
  qDeleteAll(buttons_->buttons());
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
  choose(chosen);
}

/// Shows a diagram; a missing one changes nothing.
void RegionPictures::choose(int index) {
  if (!buttons_->button(index)) return;
  const Diagram& diagram = sheet_->diagrams.at(static_cast<std::size_t>(index));
  const auto [name, range] = splitTitle(diagram);
  chosen_ = name;
  range_->setText(range);
  buttons_->button(index)->setChecked(true);
  picture_->showPicture([one = singleDiagram(diagram)](const DiagramOptions& options) {
    return composeDiagrams(one, options);
  });
  picture_->setAccessibleName(translatedText(sheet_->title) + ", " + name);
  const QString note = translatedText(sheet_->note);
  picture_->setAccessibleDescription(note);
  picture_->setToolTip(wrappedTip(note));
}

}  // namespace asperity
