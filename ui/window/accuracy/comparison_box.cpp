#include "ui/window/accuracy/comparison_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/scene/parameters.h"
#include "ui/language/language.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"

namespace asperity {

namespace {

constexpr int kHeight = 24;  // height in pixels of its entries
constexpr int kMaxOversampling = 64, kMaxLines = 10000;

QSpinBox* makeSpinBox(const char* name, int value, int most) {
  auto* box = named<SpinBox>(name);
  box->setRange(1, most);
  box->setValue(value);
  box->setKeyboardTracking(false);  // typing a number gives one change
  return box;
}

const auto& schemes() {
  return std::get<ChoiceField>(findParameter("accuracy.scheme")->field).choices;
}

}  // namespace

ComparisonBox::ComparisonBox(QWidget* parent)
    : QWidget(parent),
      compare_(named<QCheckBox>("comparisonWanted")),
      scheme_(named<ChoiceBox>("comparisonScheme")) {
  setObjectName("comparisonBox");
  for (const auto& word : schemes()) scheme_->addItem(wordText(word));
  scheme_->setCurrentIndex(static_cast<int>(Scheme::Cubic));
  scheme_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);  // its texts are not elided
  const CurveSetting usual;
  oversampling_ =
      makeSpinBox("comparisonOversampling", static_cast<int>(usual.oversampling), kMaxOversampling);
  oversampling_->setPrefix(QStringLiteral("×"));
  suggested_ = static_cast<int>(usual.realizations);
  lines_ = makeSpinBox("comparisonLines", suggested_, kMaxLines);
  connect(lines_, &QSpinBox::valueChanged, this, &ComparisonBox::showLines);

  for (QWidget* entry : Widgets{scheme_, oversampling_, lines_}) entry->setMinimumHeight(kHeight);
  auto* choice = new QHBoxLayout;
  choice->setContentsMargins(22, 0, 0, 0);
  choice->addWidget(scheme_);
  choice->addWidget(oversampling_);
  choice->addWidget(lines_, 1);
  auto* column = marginless<QVBoxLayout>(this, 4);
  column->addWidget(compare_);
  column->addLayout(choice);

  connect(scheme_, &QComboBox::currentIndexChanged, this, [this](int scheme) {
    oversampling_->setEnabled(scheme != static_cast<int>(Scheme::Nodal));
    emit settingChanged();
  });
  connect(compare_, &QCheckBox::toggled, this, &ComparisonBox::settingChanged);
  for (QSpinBox* box : {oversampling_, lines_})
    connect(box, &QSpinBox::valueChanged, this, &ComparisonBox::settingChanged);
  keepTranslated(*this, [this] { showTexts(); });
}

void ComparisonBox::showTexts() {
  compare_->setText(isEnabled() ? tr("Compare the curve with")
                                : tr("Compare the curve (only without a target accuracy)"));
  compare_->setToolTip(
      tr("Computes the curve in this way, too, on the same lines, and plots the "
         "difference below it"));
  compare_->setAccessibleName(tr("Compare the curve with"));
  scheme_->setSpoken(tr("scheme to compare with"));
  for (int i = 0; i < scheme_->count(); ++i)
    scheme_->setItemText(i, wordText(schemes()[static_cast<std::size_t>(i)]));
  for (const auto& [box, label] :
       {std::pair{oversampling_, tr("points per element to compare with")},
        {lines_, tr("lines to compare with")}}) {
    box->setAccessibleName(label);
    box->setToolTip(label);
  }
  showLines();
}

void ComparisonBox::showLines() {
  lines_->setSuffix(lines_->value() == 1 ? tr(" line") : tr(" lines"));
}

std::optional<CurveSetting> ComparisonBox::setting() const {
  if (!compare_->isChecked() || !isEnabled()) return std::nullopt;
  CurveSetting setting;
  setting.scheme = static_cast<Scheme>(scheme_->currentIndex());
  setting.oversampling = setting.scheme == Scheme::Nodal ? 1 : oversampling_->value();
  setting.realizations = lines_->value();
  return setting;
}

void ComparisonBox::suggestLines(std::int64_t lines) {
  if (lines_->value() != suggested_) return;
  suggested_ = static_cast<int>(std::min<std::int64_t>(lines, kMaxLines));
  lines_->setValue(suggested_);
}

void ComparisonBox::allow(bool allowed) {
  if (allowed == isEnabled()) return;
  setEnabled(allowed);
  showTexts();
  emit settingChanged();
}

}  // namespace asperity
