#include "ui/window/curve/comparison_commands.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/friction/theory_curve.h"
#include "core/scene/list_text.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/list_box.h"
#include "ui/window/fit/fit_page.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_tabs.h"

namespace asperity {

namespace {

QString theoryWord(Theory theory) {
  return fromUtf8(theoryWords()[static_cast<std::size_t>(theory)]);
}

/// Returns a fitted value with at least four digits, and with more where its error is smaller.
/// Further digits mean nothing and overflow the entries. A value at a limit is exact.
double roundedValue(const FittedParameter& parameter) {
  constexpr double kMin = 4, kMax = 17;
  if (parameter.isAtLimit || parameter.value == 0) return parameter.value;
  const double part = parameter.isLogarithmic ? parameter.standardError
                                              : std::abs(parameter.standardError / parameter.value);
  const double digits = part > 0 ? std::ceil(-std::log10(part)) + 1 : kMax;
  // Without an error the value is kept as it is.
  if (!std::isfinite(digits)) return parameter.value;
  return roundedToDigits(parameter.value, static_cast<int>(std::clamp(digits, kMin, kMax)));
}

bool isShown(const Scene& scene, Theory theory) {
  return std::ranges::find(scene.comparison.theory, theory) != scene.comparison.theory.end();
}

}  // namespace

ComparisonCommands::ComparisonCommands(const Parts& parts)
    : QObject(&parts.window), parts_(parts), button_(named<QToolButton>("fitButton")) {
  button_->setAutoRaise(true);
  button_->setFocusPolicy(Qt::TabFocus);
  connect(button_, &QToolButton::clicked, this, &ComparisonCommands::openFit);
  parts_.tabs.setCornerWidget(button_);
  connect(&parts_.document, &SceneDocument::sceneChanged, this,
          [this](const Scene& scene) { showScene(scene); });
  keepTranslated(*button_, [this] {
    button_->setText(tr("Fit…"));
    button_->setToolTip(tr("Fit parameters of the scene to the measured friction"));
  });
}

void ComparisonCommands::addTo(Commands& commands) {
  commands.add(
      {"fitParameters", [] { return tr("Fit to measured friction…"); }, [this] { openFit(); }});
}

void ComparisonCommands::fill(QMenu& menu, Commands& commands) {
  menu.addSeparator();
  theories_ = addSubmenu(menu, "theoryMenu", [] { return tr("Theories"); });
  theories_->setToolTipsVisible(true);
  for (const TheoryEntry& entry : theoryEntries()) {
    QAction* action = checkedEntry(
        *theories_, "theory:" + theoryWord(entry.theory), {}, false,
        [this, theory = entry.theory](bool isSelected) { takeTheory(theory, isSelected); });
    keepTranslated(*theories_, [action, &entry] {
      action->setText(capitalized(translatedText(entry.name)));
      action->setToolTip(wrappedTip(translatedText(entry.range)));
    });
  }
  menu.addAction(commands.get("openFriction"));
  tables_ = addSubmenu(menu, "measuredMenu", [] { return tr("Remove measured friction"); });
  tables_->setToolTipsVisible(true);
  connect(tables_, &QMenu::aboutToShow, this, &ComparisonCommands::fillTables);
  menu.addAction(commands.get("fitParameters"));
  showScene(parts_.document.scene());
}

/// Shows the comparisons of the scene. Theories that do not apply to it can be chosen as well, for
/// the next scene.
void ComparisonCommands::showScene(const Scene& scene) {
  for (const TheoryEntry& entry : theoryEntries())
    if (auto* action = theories_->findChild<QAction*>("theory:" + theoryWord(entry.theory)))
      action->setChecked(isShown(scene, entry.theory));
  parts_.tabs.showInCorner(*button_, !scene.comparison.data.empty());
}

void ComparisonCommands::takeTheory(Theory theory, bool isSelected) {
  Scene scene = parts_.document.scene();
  scene.comparison.theory = withTheory(scene.comparison.theory, theory, isSelected);
  parts_.document.edit(scene, QT_TRANSLATE_NOOP("asperity::SceneDocument", "Theories"));
}

/// Adds one entry for each table, with its name in the legend.
void ComparisonCommands::fillTables() {
  tables_->clear();
  const Scene& scene = parts_.document.scene();
  for (std::size_t i = 0; i < scene.comparison.data.size(); ++i) {
    const DataFile& table = scene.comparison.data[i];
    QAction* action = tables_->addAction(tableName(table), this, [this, i] { removeTable(i); });
    action->setObjectName(QStringLiteral("measured:%1").arg(i));
    action->setToolTip(fromUtf8((scene.folder / table.file).string()));
  }
  explainEmpty(*tables_, tr("The scene has no measured friction"));
}

void ComparisonCommands::removeTable(std::size_t index) {
  Scene scene = parts_.document.scene();
  std::vector<DataFile>& tables = scene.comparison.data;
  if (index >= tables.size()) return;
  tables.erase(tables.begin() + static_cast<std::ptrdiff_t>(index));
  parts_.document.edit(scene,
                       QT_TRANSLATE_NOOP("asperity::SceneDocument", "Remove measured friction"));
}

FitPage* ComparisonCommands::openFit() {
  if (parts_.document.scene().comparison.data.empty() && !parts_.addTable()) return nullptr;
  for (FitPage* page : parts_.window.findChildren<FitPage*>(Qt::FindDirectChildrenOnly))
    delete page;
  auto* page = new FitPage(parts_.document.scene(), selection_, &parts_.window);
  connect(page, &FitPage::valuesChosen, this, &ComparisonCommands::takeValues);
  connect(page, &QDialog::finished, this,
          [this, page] { selection_ = page->choices().selection(); });
  page->open();
  return page;
}

/// Takes the values alone: the scene keeps its lines and everything beside the curve.
void ComparisonCommands::takeValues(const Fit& fit) {
  Scene scene = parts_.document.scene();
  for (const FittedParameter& parameter : fit.parameters)
    setValue(*findParameter(parameter.key), scene, roundedValue(parameter));
  parts_.document.edit(scene, QT_TRANSLATE_NOOP("asperity::SceneDocument", "Fit"));
}

}  // namespace asperity
