// One row of the table of parameters as controls: label with symbol and exact entry, with a slider
// over the whole width below them, or a list of words, or a text, with a button for files where it
// names a file, or the table of an elastomer's arms, or the box of materials; description and
// allowed range as tooltip, a button that resets to the default, and below: what is missing, what
// to be warned of, and the reason of a refused text. Object names: "slider:KEY", "entry:KEY",
// "text:KEY", "arms:KEY", "shifts:KEY", "material:KEY", "choice:KEY", "browse:KEY", "reset:KEY",
// "note:KEY", "warning:KEY", "error:KEY", "row:KEY". The row holds no scene; it shows one and emits
// the user's input. Its panel decides whether it is visible. GUI thread.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "core/scene/parameters.h"
#include "ui/panels/profile_defaults.h"

class QHBoxLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace asperity {

class ChoiceBox;
class ListBox;
class MaterialBox;
class PairEditor;
class TextBox;
class ValueEntry;
class ValueSlider;

class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  /// Makes a row without texts, which showTexts() sets.
  explicit ParameterRow(const Parameter& parameter, QWidget* parent = nullptr);

  const Parameter& parameter() const { return parameter_; }

  /// Sets all texts in the language of the window.
  void showTexts();

  /// Takes another unit, other limits and another slider for the same key.
  void setParameter(const Parameter& parameter);

  /// Shows the scene's value. `replace` also overwrites refused input. `known` is the line that is
  /// shown.
  void showScene(const Scene& scene, const LineSize& known, bool replace);

  /// Shows why the text that was typed here is refused; an empty reason removes it.
  void showRefusal(const QString& reason);

  /// Shows an error that occurred when the scene ran; an empty text removes it. While a text is
  /// refused the reason of that is shown instead.
  void showRunError(const QString& text);

  /// Shows what is missing here; an empty text removes it.
  void showNote(const QString& text);

  /// Shows why results of this value are uncertain; an empty text removes it.
  void showWarning(const QString& text);

  /// Returns whether there is something to read below the controls.
  bool hasRemark() const;

  /// Returns whether the user drags its slider. released() follows.
  bool isHeld() const;

  /// Locks the row: it shows its value and cannot be changed.
  void setLocked(bool locked);

  /// Gives its first control the focus.
  void takeFocus();

  /// Returns whether the scene's value differs from that of the reset button.
  bool isChanged() const;

 signals:
  void valueGiven(const asperity::ParameterValue& value);
  void textGiven(const QString& text);
  void fileRequested();
  /// Emitted when the user no longer drags its slider.
  void released();
  /// Emitted when the user requests the guide about the row, at this anchor.
  void guideRequested(const QString& anchor);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  enum class Remark { Note, Warning, Error };  // from above
  void addLabel(QHBoxLayout& line);
  void addEntry();
  void addNumber(QHBoxLayout& line, QVBoxLayout& column);
  void addChoice(QHBoxLayout& line, const ChoiceField& field);
  void addText(QHBoxLayout& line);
  void addLongText(QHBoxLayout& line);
  void addTable(QHBoxLayout& line, QVBoxLayout& column, PairEditor& table, const char* kind);
  void addMaterials(QHBoxLayout& line);
  void addListBox(QHBoxLayout& line);
  void addBrowse(QHBoxLayout& line);
  void addReset(QHBoxLayout& line);
  void showError();
  void showRemark(Remark kind, const QString& text);
  void showEnabled();
  void setWidths();
  void showOnSlider(double value, bool replace);
  void showEntry(const ParameterValue& value, const std::optional<Placeholder>& placeholder,
                 bool replace);
  void showReset(const ParameterValue& value, const ParameterValue& initial);
  QString nameFor(const char* kind) const;
  void speak();
  QString tip() const;

  Parameter parameter_;
  Rheology rheology_ = Rheology::Kelvin;     // of the scene, whose formulas the tooltips have
  bool isLocked_ = false, isFixed_ = false;  // locked by the panel, fixed by the scene
  bool isSliderLonger_ = false;  // than that of the parameter, to reach the scene's value
  ValueSlider* slider_ = nullptr;
  ValueEntry* entry_ = nullptr;
  ChoiceBox* choice_ = nullptr;
  PairEditor* table_ = nullptr;  // of arms or shifts
  MaterialBox* material_ = nullptr;
  ListBox* list_ = nullptr;
  TextBox* text_ = nullptr;  // for several sentences
  QLabel* label_ = nullptr;
  QLabel* unit_ = nullptr;  // for numbers
  QToolButton* browse_ = nullptr;
  QToolButton* reset_ = nullptr;
  ParameterValue resetValue_;  // value of the reset button
  QString refusal_, runError_;
  std::array<QLabel*, 3> remarks_{};  // below the controls; null until there is something to say
};

}  // namespace asperity
