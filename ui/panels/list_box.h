// A box that selects what is drawn beside the friction curve: the theories, or the tables of
// measured friction. It shows the name of one, the number of several; its list has a check mark at
// each one that is shown. The last entry of the list of tables opens a file dialog. Object names of
// the entries: "shown:NUMBER", "addTable". GUI thread; owned by its parent.
#pragma once

#include <string>
#include <vector>

#include "core/scene/parameters.h"
#include "ui/panels/boxes.h"

class QMenu;

namespace asperity {

class ListBox : public ChoiceBox {
  Q_OBJECT

 public:
  /// `key` is comparison.theory or comparison.data.
  explicit ListBox(std::string key, QWidget* parent = nullptr);

  /// Shows what the scene names.
  void showScene(const Scene& scene);
  void showTexts();

  void showPopup() override;

 signals:
  /// Emitted with the list after an entry was added or removed, as the scene's JSON text.
  void listGiven(const asperity::ParameterValue& json);
  void fileRequested();

 private:
  bool hasTheories() const { return key_ == "comparison.theory"; }
  QStringList names() const;
  void addTheories(QMenu& menu);
  void addTables(QMenu& menu);

  std::string key_;
  Scene scene_;
};

/// Returns the theories with or without one of them, in their order.
std::vector<Theory> withTheory(std::vector<Theory> theories, Theory theory, bool isSelected);

/// Returns the name of a table in legends and lists.
QString tableName(const DataFile& table);

}  // namespace asperity
