// A list of pairs of numbers as a table: two values in each row in engineering units, in a certain
// order, with buttons to add, to remove and to paste a table; a long table is folded under a line
// that summarizes it. A refused value stays as it was typed, with the reason below it. Every
// accepted change passes on the whole list. Kinds of lists derive from it: elastomer_tables.h.
// Object names, where the names of the kind are "arm" and "armTime", for example:
// "armsFold", "armsAdd", "armsPaste", "armsRefusal", and from 0 "armTime:I", "armRemove:I",
// "armError:I". GUI thread; owned by its parent.
#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "ui/panels/number_text.h"

class QGridLayout;
class QLabel;
class QToolButton;

namespace asperity {

class PairRow;
struct TextBlock;

class PairEditor : public QWidget {
  Q_OBJECT

 public:
  using Pair = std::array<double, 2>;
  using Pairs = std::vector<Pair>;

  ~PairEditor() override;

  /// Returns a list as pairs of two members of its items, and pairs as such a list.
  template <class Item>
  static Pairs toPairs(const std::vector<Item>& items, double Item::*first, double Item::*second) {
    Pairs pairs;
    for (const Item& item : items) pairs.push_back({item.*first, item.*second});
    return pairs;
  }
  template <class Item>
  static std::vector<Item> fromPairs(const Pairs& pairs, double Item::*first,
                                     double Item::*second) {
    std::vector<Item> items(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      items[i].*first = pairs[i][0];
      items[i].*second = pairs[i][1];
    }
    return items;
  }

  /// Returns the line with the fold, for the row of the panel.
  QToolButton& fold() { return *fold_; }

  /// Shows the list of the scene. `replace` also overwrites refused input.
  virtual void showScene(const Scene& scene, bool replace) = 0;

 signals:
  /// Emitted with the list, in its order, as the scene's JSON text.
  void listGiven(const asperity::ParameterValue& json);

 protected:
  /// The differences between the kinds of lists; the texts are requested again after a change of
  /// the language.
  struct Kind {
    const char* name;                    // "arm", of objects
    std::array<const char*, 2> columns;  // "armModulus", of objects
    std::array<NumberRule, 2> rules;
    std::size_t sortedBy;  // column
    std::size_t most;      // rows
    bool mayBeEmpty;
  };
  struct Texts {
    std::array<QString, 2> headings;  // rich text
    std::array<QString, 2> cells;     // of row %1
    QString one;                      // a list of one row
    QString add, addTip, paste, pasteTip, removeTip, removeName, foldName;
  };

  PairEditor(const Kind& kind, QWidget* parent);
  /// Sets the texts of the kind, and again whenever the language changes; the constructor of a kind
  /// calls it at its end.
  void begin();

  /// Shows the pairs. `prescribed`: the number of rows, if it is fixed. `replace` also overwrites
  /// refused input.
  void showPairs(Pairs pairs, std::optional<std::size_t> prescribed, bool replace);

  virtual Texts texts() const = 0;
  /// Returns the row that is added to these.
  virtual Pair next(const Pairs& pairs) const = 0;
  /// Reads a table from the clipboard. Throws InputError.
  virtual Pairs fromTable(std::string_view text) const = 0;
  /// Returns the list as the scene's JSON text.
  virtual ParameterValue toValue(const Pairs& pairs) const = 0;

  /// Replaces all rows by a table that is pasted into one of the entries.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  friend class PairRow;

  Pairs sorted(Pairs pairs) const;
  QString partName(const char* part) const;
  void pass(Pairs pairs);
  void change(std::size_t index, const Pair& pair);
  void add();
  void paste();
  void remove(std::size_t index);
  void makeRows(std::size_t count);
  void showTexts();
  void showFold();
  bool isOpen() const;

  const Kind kind_;
  Pairs pairs_;
  std::optional<std::size_t> prescribed_;  // number of rows
  std::optional<bool> opened_;             // by the user; otherwise a short list is open
  std::vector<std::unique_ptr<PairRow>> rows_;
  QToolButton* fold_;
  QWidget* table_;
  QGridLayout* grid_;
  std::array<QLabel*, 2> headings_{};
  QToolButton *add_, *paste_;
  QLabel* refusal_;  // why a table was not taken
};

/// Returns the columns of a pasted table that hold numbers, without one that counts the rows.
std::vector<std::size_t> columnsOfNumbers(const TextBlock& block);

}  // namespace asperity
