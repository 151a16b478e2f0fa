#include "ui/panels/list_box.h"

#include <QMenu>
#include <algorithm>
#include <utility>

#include "core/friction/theory_curve.h"
#include "core/scene/list_text.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"

namespace asperity {

ListBox::ListBox(std::string key, QWidget* parent) : ChoiceBox(parent), key_(std::move(key)) {
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(8);
}

void ListBox::showScene(const Scene& scene) {
  const bool isSame = count() > 0 && scene.comparison == scene_.comparison;
  scene_ = scene;
  if (!isSame) showTexts();
}

QStringList ListBox::names() const {
  QStringList names;
  if (hasTheories())
    for (const Theory theory : scene_.comparison.theory)
      names << translatedText(theoryEntry(theory).name);
  else
    for (const DataFile& table : scene_.comparison.data) names << tableName(table);
  return names;
}

void ListBox::showTexts() {
  const QStringList shown = names();
  QString text = shown.value(0, tr("none"));
  if (shown.size() > 1)
    text = (hasTheories() ? tr("%1 theories") : tr("%1 tables")).arg(shown.size());
  clear();
  addItem(text);
}

void ListBox::showPopup() {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  if (hasTheories())
    addTheories(*menu);
  else
    addTables(*menu);
  menu->popup(mapToGlobal(QPoint(0, height())));
}

void ListBox::addTheories(QMenu& menu) {
  for (const TheoryEntry& entry : theoryEntries()) {
    const std::vector<Theory>& shown = scene_.comparison.theory;
    QAction* action = checkedEntry(
        menu, QStringLiteral("shown:%1").arg(static_cast<int>(entry.theory)),
        translatedText(entry.name), std::ranges::find(shown, entry.theory) != shown.end(),
        [this, theory = entry.theory](bool isSelected) {
          emit listGiven(listText(withTheory(scene_.comparison.theory, theory, isSelected)));
        });
    action->setToolTip(wrappedTip(translatedText(entry.range)));
  }
}

void ListBox::addTables(QMenu& menu) {
  for (std::size_t i = 0; i < scene_.comparison.data.size(); ++i) {
    const DataFile& table = scene_.comparison.data[i];
    const auto remove = [this, i](bool) {
      std::vector<DataFile> tables = scene_.comparison.data;
      if (i < tables.size()) tables.erase(tables.begin() + static_cast<std::ptrdiff_t>(i));
      emit listGiven(listText(tables));
    };
    QAction* action =
        checkedEntry(menu, QStringLiteral("shown:%1").arg(i), tableName(table), true, remove);
    action->setToolTip(fromUtf8((scene_.folder / table.file).string()));
  }
  if (!menu.isEmpty()) menu.addSeparator();
  menu.addAction(tr("Add a table…"), this, &ListBox::fileRequested)->setObjectName("addTable");
}

std::vector<Theory> withTheory(std::vector<Theory> theories, Theory theory, bool isSelected) {
  std::erase(theories, theory);
  if (isSelected) theories.push_back(theory);
  std::ranges::sort(theories);
  return theories;
}

QString tableName(const DataFile& table) {
  return fromUtf8(table.label.empty() ? table.file : table.label);
}

}  // namespace asperity
