#include "ui/panels/material_box.h"

#include <QFileInfo>
#include <QIcon>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/material/element_law.h"
#include "core/material/material_library.h"
#include "core/scene/scene_files.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

constexpr QSize kPreview{64, 26};  // pixels
constexpr int kAsksForFile = Qt::UserRole + 1;

/// Returns the name of a shipped material for people.
std::string shippedName(const ShippedFile& material) {
  return jsonOrDiscarded(material.json).value("name", std::string(material.name));
}

/// Returns a shipped material.
Elastomer shippedElastomer(const ShippedFile& material) {
  Scene scene;
  useMaterial(scene, std::string(material.name));
  return scene.elastomer;
}

/// Draws storage modulus (solid) and loss modulus (pale) of an elastomer over all frequencies at
/// which its arms relax, both logarithmic.
QIcon modulusIcon(const Elastomer& elastomer, const QSize& size, const QPalette& palette) {
  if (elastomer.arms.empty()) return {};
  double shortest = HUGE_VAL, longest = 0;
  for (const Arm& arm : elastomer.arms) {
    if (!(arm.relaxationTime > 0)) continue;
    shortest = std::min(shortest, arm.relaxationTime);
    longest = std::max(longest, arm.relaxationTime);
  }
  if (!(longest > 0)) return {};
  const double from = std::log10(0.1 / longest), to = std::log10(10 / shortest);
  constexpr int kPoints = 48;
  ElementLaw law;
  law.equilibriumModulus = elastomer.equilibriumModulus;
  law.arms = elastomer.arms;
  std::vector<ComplexModulus> points;  // their decimal logarithms
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (int i = 0; i < kPoints; ++i) {
    const auto [storage, loss] =
        complexModulus(law, std::pow(10, from + (to - from) * i / (kPoints - 1)));
    points.push_back({std::log10(std::max(storage, 1e-30)), std::log10(std::max(loss, 1e-30))});
    lowest = std::min({lowest, points.back().storage, points.back().loss});
    highest = std::max({highest, points.back().storage, points.back().loss});
  }
  constexpr double kDensity = 2;
  QPixmap pixmap(size * kDensity);
  pixmap.setDevicePixelRatio(kDensity);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto draw = [&](double ComplexModulus::*value, const QPen& pen) {
    QPainterPath path;
    for (int i = 0; i < kPoints; ++i) {
      const double share =
          (points[static_cast<std::size_t>(i)].*value - lowest) / std::max(highest - lowest, 1e-9);
      const QPointF at(2 + (size.width() - 4.0) * i / (kPoints - 1),
                       size.height() - 3 - (size.height() - 6.0) * share);
      if (i == 0)
        path.moveTo(at);
      else
        path.lineTo(at);
    }
    painter.setPen(pen);
    painter.drawPath(path);
  };
  draw(&ComplexModulus::loss, QPen(palette.color(QPalette::PlaceholderText), 1.4));
  draw(&ComplexModulus::storage, QPen(palette.color(QPalette::Highlight), 1.8));
  return pixmap;
}

}  // namespace

MaterialBox::MaterialBox(QWidget* parent) : ChoiceBox(parent) {
  setIconSize(kPreview);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(8);
  connect(this, &QComboBox::activated, this, &MaterialBox::pick);
}

void MaterialBox::showMaterial(const Elastomer& elastomer) {
  const bool isSame = count() > 0 && elastomer.material == elastomer_.material;
  elastomer_ = elastomer;
  if (!isSame) showTexts();
}

void MaterialBox::showTexts() {
  clear();
  addItem(tr("own values"), QString());
  for (const ShippedFile& material : shippedMaterials())
    addItem(translatedText(shippedName(material)), fromUtf8(material.name));
  const QString present = QString::fromStdString(elastomer_.material);
  if (findData(present) < 0) {
    addItem(QFileInfo(present).fileName(), present);
    setItemData(count() - 1, present, Qt::ToolTipRole);
  }
  setCurrentIndex(findData(present));
  insertSeparator(count());
  addItem(tr("Open material…"), QString());
  setItemData(count() - 1, true, kAsksForFile);
}

/// Draws the pictures of the moduli, in the present colours of the window.
void MaterialBox::showPopup() {
  for (const ShippedFile& material : shippedMaterials())
    setItemIcon(findData(fromUtf8(material.name)),
                modulusIcon(shippedElastomer(material), kPreview, palette()));
  if (currentIndex() >= 0 && itemIcon(currentIndex()).isNull())
    setItemIcon(currentIndex(), modulusIcon(elastomer_, kPreview, palette()));
  ChoiceBox::showPopup();
}

/// Returns the height of the other boxes: only the open list has the pictures.
QSize MaterialBox::minimumSizeHint() const {
  return {ChoiceBox::minimumSizeHint().width(), sizeHint().height()};
}

void MaterialBox::pick(int index) {
  const bool asks = itemData(index, kAsksForFile).toBool();
  const QString name = itemData(index).toString();
  // The box shows the present material until the panel has accepted another one.
  setCurrentIndex(findData(QString::fromStdString(elastomer_.material)));
  if (asks)
    emit fileRequested();
  else
    emit nameGiven(name);
}

}  // namespace asperity
