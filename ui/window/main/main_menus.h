// The menus and the tool bar of the main window, in the order on the screen. GUI thread. Cannot
// fail.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <string_view>

class QMainWindow;

namespace asperity {

class Appearance;
class Commands;
class ComparisonCommands;
class ContactCanvas;
class CurveCommands;
class DocumentCommands;
class WindowLayout;
class WindowPages;

/// The parts of the window that fill menus, and what their entries call.
struct MenuParts {
  QMainWindow& window;
  Commands& commands;  // with those of all parts
  DocumentCommands& documents;
  WindowPages& pages;
  ContactCanvas& canvas;
  WindowLayout& layout;
  CurveCommands& curve;
  ComparisonCommands& comparisons;
  Appearance& appearance;
  std::function<void(const QString& name)> openScene;  // a shipped one
  std::function<void(std::string_view code)> useLanguage;
  std::function<QStringList()> playTexts;  // all texts of the button that plays and pauses
};

/// Adds them to the window, once.
void addMenus(const MenuParts& parts);

}  // namespace asperity
