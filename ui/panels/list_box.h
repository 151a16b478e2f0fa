// A box for what stands beside the friction curve: the theories, or the tables of measured
// friction. It shows the name of one, the number of several; its list has a check at each one that
// is shown. The list of tables has a last entry that asks for a file. Object names of the entries:
// "shown:NUMBER", "addTable". GUI thread; belongs to its parent.
#pragma once

#include <string>
#include <vector>

#include "core/scene/parameters.h"
#include "ui/panels/choice_box.h"

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
  /// The list without or with one more entry, as the scene's JSON text.
  void listGiven(const asperity::ParameterValue& json);
  void fileWanted();

 private:
  bool hasTheories() const { return key_ == "comparison.theory"; }
  QStringList names() const;
  void addTheories(QMenu& menu);
  void addTables(QMenu& menu);

  std::string key_;
  Scene scene_;
};

/// Returns the theories with or without one of them, in their order.
std::vector<Theory> withTheory(std::vector<Theory> theories, Theory theory, bool isWanted);

/// Returns the name of a table in legends and lists.
QString nameOf(const DataFile& table);

}  // namespace asperity
