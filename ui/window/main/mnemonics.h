// Letters of menu entries: with Alt held or a menu open one letter takes an entry. Chosen when a
// menu opens, so that every entry has one of its own in each language and in menus that come and
// go. GUI thread. Cannot fail: an entry whose letters are all taken has none.
#pragma once

#include <QStringList>

class QMenu;

namespace asperity {

/// The texts with '&' before a letter or digit that is no other's, at the beginning of a word where
/// that can be; marks that were there go, "&&" stays.
QStringList withMnemonics(const QStringList& texts);

/// From now on, for what is visible whenever the menu opens.
void keepMnemonics(QMenu& menu);

}  // namespace asperity
