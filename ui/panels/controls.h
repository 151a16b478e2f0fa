// What all panels and pages share: short ways to make usual controls and layouts, questions, and
// the bar with the title of a page. GUI thread; owned by their parent. Cannot fail.
#pragma once

#include <QCoreApplication>
#include <QFormLayout>
#include <QMessageBox>
#include <QPushButton>
#include <QString>
#include <QWidget>
#include <functional>
#include <initializer_list>
#include <utility>

class QAction;
class QHBoxLayout;
class QKeyEvent;
class QLabel;
class QMenu;
class QPlainTextEdit;
class QProgressBar;
class QScrollArea;
class QSplitter;
class QToolButton;

namespace asperity {

/// Makes a control with the object name by which style sheets and tests find it.
template <class Control, class... Arguments>
Control* named(const QString& name, Arguments&&... arguments) {
  auto* control = new Control(std::forward<Arguments>(arguments)...);
  control->setObjectName(name);
  return control;
}

/// Makes a field of a form with its label, which is also its name for screen readers.
template <class Field>
Field* addField(QFormLayout& form, const QString& name, const QString& label,
                const QString& tip = {}) {
  auto* field = named<Field>(name);
  field->setAccessibleName(QString(label).remove('&'));
  field->setToolTip(tip);
  form.addRow(label, field);
  return field;
}

/// Makes a button of a page, which the Return key presses only where it has the focus. press:
/// called by a click.
template <class Receiver, class Press>
QPushButton* pageButton(const QString& name, const QString& text, Receiver* receiver, Press press) {
  auto* button = named<QPushButton>(name, text);
  button->setAutoDefault(false);
  QObject::connect(button, &QPushButton::clicked, receiver, press);
  return button;
}

/// Widgets of several kinds, for a loop over them.
using Widgets = std::initializer_list<QWidget*>;

/// Makes the row of buttons at the foot of a page, some of them at its left and some at its right
/// end.
QHBoxLayout* buttonRow(Widgets left, Widgets right);

/// Makes a layout without margins. spacing: pixels between its items; -1: as the style says.
template <class Layout>
Layout* marginless(QWidget* parent = nullptr, int spacing = -1) {
  auto* layout = new Layout(parent);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

/// Gives the Tab key the order of a layout, beginning after `before`: Qt puts controls last that
/// were made last. Returns the last control.
QWidget& orderTabs(QWidget& before, const QLayout& layout);

/// Returns whether a key is Return, or Enter beside the digits.
bool isReturnKey(const QKeyEvent& event);

/// Makes a splitter with a thin handle, none of whose parts can be closed.
QSplitter* thinSplitter(Qt::Orientation orientation, const QString& name = {});

/// Sets whether a layout keeps the space of a widget while it is hidden, so that nothing moves.
void keepSpaceWhenHidden(QWidget& widget, bool keeps = true);

/// Shows or hides a field of a form with its label.
void setRowShown(QFormLayout& form, QWidget* field, bool isShown);

/// Makes an area without a frame in which the content scrolls, as wide as the area.
QScrollArea* scrolled(QWidget* content, Qt::ScrollBarPolicy sideways = Qt::ScrollBarAsNeeded);

/// Makes a thin bar of progress without a text.
QProgressBar* thinProgress(const QString& name, int width = 120);

/// Shows the finished part of some work, 0 to 1, in steps of a thousandth.
void showPart(QProgressBar& bar, double part);

/// Makes a text in a font of fixed width, which a user can only read.
QPlainTextEdit* fixedText(const QString& name);

/// Adds an entry with a check mark to a menu, or to a group of actions that may be in several
/// menus. choose: called with the new state when the user chooses the entry.
QAction* checkedEntry(QObject& menuOrGroup, const QString& name, const QString& text,
                      bool isChecked, std::function<void(bool isChecked)> choose);

/// Adds a submenu; `title` returns its title in the language of the window.
QMenu* addSubmenu(QMenu& menu, const QString& name, std::function<QString()> title);

/// A question in plain text: titles and file names are not markup.
struct Question {
  QString name;  // of the dialog, as an object
  QString title, text, explanation{};
  QMessageBox::Icon icon = QMessageBox::Question;
};

/// Asks a question and returns the button that was pressed. answers: the buttons with their texts,
/// because not every desktop gives its standard buttons a shortcut letter. The Escape key means
/// Cancel, or the usual answer where there is no Cancel.
QMessageBox::StandardButton ask(
    QWidget* parent, const Question& question,
    std::initializer_list<std::pair<QMessageBox::StandardButton, QString>> answers,
    QMessageBox::StandardButton usual);

/// Asks the user for a file or a folder, beginning with a proposal; empty where none was chosen. It
/// stands for a dialog, so that another one can replace it.
using FileChooser = std::function<QString(QWidget* parent, const QString& proposed)>;

/// The bar with the title of a dock or a page, and at its end the button that closes it.
class TitleBar : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(asperity::TitleBar)

 public:
  explicit TitleBar(const QString& closeName = {}, QWidget* parent = nullptr);

  QLabel& title() { return *title_; }
  QToolButton& closeButton() { return *close_; }
  /// Puts a control between the title and the button.
  void insert(QWidget& control);
  /// Lets the button lead back from a page that covers the contact, and also the Escape key: close
  /// and escape are called.
  void leadBack(QWidget& page, const std::function<void()>& close,
                const std::function<void()>& escape);

 private:
  QLabel* title_;
  QToolButton* close_;
};

}  // namespace asperity
