#include "ui/window/main/mnemonics.h"

#include <QAction>
#include <QMap>
#include <QMenu>
#include <QSet>
#include <vector>

namespace asperity {

namespace {

const QChar kAnd = u'\x1';  // in the place of "&&"

QString plain(QString text) {
  return text.replace(QStringLiteral("&&"), kAnd).remove(u'&');
}

/// Places of letters and digits, those at the beginning of a word first.
std::vector<qsizetype> placesIn(const QString& text) {
  std::vector<qsizetype> first, others;
  for (qsizetype i = 0; i < text.size(); ++i)
    if (text[i].isLetterOrNumber()) (i == 0 || text[i - 1].isSpace() ? first : others).push_back(i);
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

/// Which entry has which letter, found by letting those before give way to another letter of theirs
/// (augmenting paths).
class Letters {
 public:
  explicit Letters(const QStringList& texts) : texts_(texts) {}

  void give(int entry) {
    QSet<QChar> asked;
    take(entry, asked);
  }

  qsizetype placeOf(int entry) const {
    for (const qsizetype place : placesIn(texts_[entry]))
      if (owners_.value(letter(entry, place), -1) == entry) return place;
    return -1;
  }

 private:
  QChar letter(int entry, qsizetype place) const { return texts_[entry][place].toLower(); }

  bool take(int entry, QSet<QChar>& asked) {
    const std::vector<qsizetype> places = placesIn(texts_[entry]);
    for (const qsizetype place : places) {
      if (owners_.contains(letter(entry, place))) continue;
      owners_[letter(entry, place)] = entry;
      return true;
    }
    for (const qsizetype place : places) {
      const QChar wanted = letter(entry, place);
      if (asked.contains(wanted)) continue;
      asked += wanted;
      if (!take(owners_[wanted], asked)) continue;
      owners_[wanted] = entry;
      return true;
    }
    return false;
  }

  const QStringList& texts_;
  QMap<QChar, int> owners_;
};

}  // namespace

QStringList withMnemonics(const QStringList& texts) {
  QStringList marked;
  for (const QString& text : texts) marked += plain(text);
  Letters letters(marked);
  for (int i = 0; i < marked.size(); ++i) letters.give(i);
  QList<qsizetype> places;
  for (int i = 0; i < marked.size(); ++i) places += letters.placeOf(i);
  for (int i = 0; i < marked.size(); ++i) {
    if (places[i] >= 0) marked[i].insert(places[i], u'&');
    marked[i].replace(kAnd, QStringLiteral("&&"));
  }
  return marked;
}

void keepMnemonics(QMenu& menu) {
  QObject::connect(&menu, &QMenu::aboutToShow, &menu, [&menu] {
    QList<QAction*> entries;
    QStringList texts;
    for (QAction* action : menu.actions()) {
      if (action->isSeparator() || !action->isVisible()) continue;
      entries += action;
      texts += action->text();
    }
    const QStringList marked = withMnemonics(texts);
    for (qsizetype i = 0; i < entries.size(); ++i) entries[i]->setText(marked[i]);
  });
}

}  // namespace asperity
