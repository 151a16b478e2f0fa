// The page of the paper's figures as a person uses it: with the real figures of few lines, and with
// figures that never end or that fail.
#include "ui/window/figures/figures_page.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QProgressBar>
#include <QSpinBox>
#include <QTemporaryDir>
#include <stdexcept>
#include <vector>

#include "tests/ui/window/figures/figures_page_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/figures/figure_list.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/message_bar.h"

namespace asperity {
namespace {

TEST_F(PageTest, AFigureIsComputedShownAndKept) {
  FiguresPage& page = show(makeFigure);
  control<QSpinBox>("realizations").setValue(2);
  std::vector<double> parts;
  QObject::connect(&page.queue(), &FigureQueue::changed, [&](FigureName name) {
    EXPECT_EQ(name, FigureName::Exponents);
    if (status(name).work == FigureStage::Computing) parts.push_back(status(name).part);
  });
  page.choose(FigureName::Exponents, true);
  EXPECT_TRUE(control<QProgressBar>("figureProgress").isVisible());
  EXPECT_FALSE(control<QPushButton>("openAsScene").isEnabled());
  ASSERT_TRUE(waitUntilMade(FigureName::Exponents));

  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_GE(std::set<double>(parts.begin(), parts.end()).size(), 5U);
  EXPECT_EQ(status(FigureName::Exponents).made->realizations, 2);
  EXPECT_FALSE(control<QProgressBar>("figureProgress").isVisible());
  EXPECT_TRUE(control<QPushButton>("openAsScene").isEnabled());
  EXPECT_EQ(claims().rowCount(),
            static_cast<int>(status(FigureName::Exponents).made->figure.claims.size()));
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  EXPECT_GT(coloursOf(page.picture()), 20U);

  const auto made = status(FigureName::Exponents).made;
  page.choose(FigureName::Hurst, false);
  EXPECT_EQ(claims().rowCount(), 0);
  EXPECT_FALSE(control<QPushButton>("savePicture").isEnabled());
  page.choose(FigureName::Exponents, true);  // there already
  EXPECT_EQ(status(FigureName::Exponents).work, FigureStage::None);
  EXPECT_EQ(status(FigureName::Exponents).made, made);
}

TEST_F(PageTest, TheContactIsDrawnAsOne) {
  FiguresPage& page = show(makeFigure);
  page.choose(FigureName::Contact, true);
  ASSERT_TRUE(waitUntilMade(FigureName::Contact));
  ASSERT_TRUE(status(FigureName::Contact).made->contact);
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  EXPECT_GT(coloursOf(page.picture()), 100U);
}

TEST_F(PageTest, ThePictureFollowsSizeAndTheme) {
  FiguresPage& page = show(quickFigure);
  page.choose(FigureName::Forces, true);
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  const auto corner = [&] { return page.picture().grab().toImage().pixelColor(1, 1).lightness(); };
  EXPECT_GT(corner(), 200);
  const QPalette light = QApplication::palette();
  QApplication::setPalette(themePalette(darkTheme()));
  restyle();
  EXPECT_FALSE(page.picture().isPainted());
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  EXPECT_LT(corner(), 80);
  QApplication::setPalette(light);
  page.resize(1300, 800);
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
}

/// The letters of a presentation come and go.
TEST_F(PageTest, PictureAndClaimsFollowTheLetters) {
  FiguresPage& page = show(makeFigure);
  page.resize(1280, 720);
  page.choose(FigureName::Contact, true);
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  const auto widths = [&] {
    QCoreApplication::processEvents();
    QList<int> all;
    for (int i = 0; i < claims().columnCount(); ++i) all += claims().columnWidth(i);
    for (int i = 0; i < claims().rowCount(); ++i) all += claims().rowHeight(i);
    return all;
  };
  const QList<int> before = widths();
  const QImage picture = page.picture().image();
  const QFont font = QApplication::font();
  QFont large = font;
  large.setPointSizeF(1.5 * font.pointSizeF());
  for (const QFont& letters : {large, font}) {
    QApplication::setFont(letters);
    restyle();
    QCoreApplication::processEvents();
    ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
    // Rows follow their column by an event of its own, thus not at once.
    EXPECT_TRUE(waitFor([&] { return (widths() == before) == (letters == font); }));
    EXPECT_GT(claims().columnWidth(1), claims().width() / 4);
  }
  page.picture().setFixedSize(picture.size());
  page.picture().setFont(large);
  ASSERT_TRUE(waitFor([&] { return page.picture().isPainted(); }));
  EXPECT_NE(page.picture().image(), picture);
}

TEST_F(PageTest, CancelEndsWhatIsComputedAndWhatWaits) {
  bool isEndless = true;
  FiguresPage& page = show([&](FigureName name, const FigureOptions& options) {
    return isEndless ? endlessFigure(name, options) : quickFigure(name, options);
  });
  page.choose(FigureName::Hurst, true);
  page.choose(FigureName::Forces, true);
  EXPECT_EQ(status(FigureName::Forces).work, FigureStage::Waiting);
  ASSERT_TRUE(waitFor([&] { return isComputing(FigureName::Hurst); }));
  EXPECT_EQ(control<QProgressBar>("figureProgress").value(), 250);
  EXPECT_EQ(stateText(FigureName::Hurst, status(FigureName::Hurst)), "25 %");
  click("cancel");
  ASSERT_TRUE(waitFor([&] { return !page.queue().computing(); }));
  for (const FigureName name : {FigureName::Hurst, FigureName::Forces}) {
    EXPECT_EQ(status(name).work, FigureStage::None);
    EXPECT_FALSE(status(name).made);
    EXPECT_TRUE(status(name).error.isEmpty());
  }
  EXPECT_FALSE(page.messages().isVisible());
  EXPECT_FALSE(control<QPushButton>("cancel").isVisible());

  isEndless = false;
  click("compute");
  EXPECT_TRUE(waitUntilMade(FigureName::Forces));
}

TEST_F(PageTest, AllFiguresComeOneAfterAnother) {
  std::vector<FigureName> made;
  FiguresPage& page = show([&](FigureName name, const FigureOptions& options) {
    made.push_back(name);  // by one thread at a time
    return quickFigure(name, options);
  });
  click("paper");
  click("computeAll");
  ASSERT_TRUE(waitUntilMade(FigureName::Spacing));
  std::vector<FigureName> all;
  for (const FigureEntry& entry : figureEntries()) {
    all.push_back(entry.name);
    EXPECT_EQ(status(entry.name).made->realizations, FiguresPage::kPaper);
  }
  EXPECT_EQ(made, all);
  click("computeAll");  // as many lines: nothing to do
  EXPECT_FALSE(page.queue().computing());
  click("quick");
  click("computeAll");
  ASSERT_TRUE(waitFor(
      [&] { return status(FigureName::Spacing).made->realizations == FiguresPage::kQuick; }));
  EXPECT_EQ(made.size(), 2 * all.size());
}

TEST_F(PageTest, WhatFailsIsSaidInOneSentence) {
  FiguresPage& page = show([](FigureName name, const FigureOptions& options) {
    if (name == FigureName::Hurst) throw std::runtime_error("the force balance is not met");
    return quickFigure(name, options);
  });
  page.choose(FigureName::Hurst, true);
  ASSERT_TRUE(waitFor([&] { return page.messages().isVisible(); }));
  EXPECT_EQ(page.messages().text(), "the force balance is not met");
  EXPECT_EQ(stateText(FigureName::Hurst, status(FigureName::Hurst)), "failed");
  page.choose(FigureName::Forces, true);
  EXPECT_FALSE(page.messages().isVisible());  // it is not this figure's
  EXPECT_TRUE(waitUntilMade(FigureName::Forces));
}

TEST_F(PageTest, ClaimsUnfoldAndStayWhileTheFigureIsComputedAgain) {
  bool isEndless = false;
  FiguresPage& page = show([&](FigureName name, const FigureOptions& options) {
    return isEndless ? endlessFigure(name, options) : quickFigure(name, options);
  });
  page.choose(FigureName::Forces, true);
  ASSERT_TRUE(waitUntilMade(FigureName::Forces));
  const auto sentence = [&] { return claims().item(0, 1)->text(); };
  EXPECT_EQ(sentence(), "It grows");
  EXPECT_TRUE(claims().item(0, 0)->toolTip().contains("It does."));
  const int folded = claims().rowHeight(0);
  QTest::mouseClick(claims().viewport(), Qt::LeftButton, {},
                    claims().visualItemRect(claims().item(0, 1)).center());
  EXPECT_TRUE(sentence().contains("above zero"));
  EXPECT_TRUE(sentence().contains("It does."));
  EXPECT_GT(claims().rowHeight(0), folded);

  isEndless = true;
  click("compute");
  ASSERT_TRUE(waitFor([&] { return isComputing(FigureName::Forces); }));
  EXPECT_TRUE(sentence().contains("It does."));
}

TEST_F(PageTest, FiguresAreSaved) {
  FiguresPage& page = show(quickFigure);
  page.choose(FigureName::Plateau, true);
  ASSERT_TRUE(waitUntilMade(FigureName::Plateau));
  const QTemporaryDir folder;
  const auto& note = *page.findChild<QLabel*>("figuresNote");
  const auto bytesOf = [&](const char* name, void (FiguresPage::*save)(const QString&)) {
    (page.*save)(folder.filePath(name));
    EXPECT_TRUE(waitFor([&] { return note.text() == "Saved " + folder.filePath(name); })) << name;
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
    return file.readAll();
  };
  EXPECT_TRUE(bytesOf("a.png", &FiguresPage::savePicture).startsWith("\x89PNG"));
  EXPECT_TRUE(bytesOf("a.svg", &FiguresPage::savePicture).contains("<svg"));
  EXPECT_TRUE(bytesOf("a.pdf", &FiguresPage::savePicture).startsWith("%PDF"));
  // The scene in front, as in every table in a file.
  const QByteArray table = bytesOf("a.csv", &FiguresPage::saveData);
  EXPECT_TRUE(table.startsWith("# asperity: {")) << table.toStdString();
  EXPECT_TRUE(table.endsWith("}\nx,y\n1,1\n")) << table.toStdString();
  EXPECT_TRUE(bytesOf("a.json", &FiguresPage::saveData).contains("it_grows"));

  page.savePicture(folder.filePath("no/such/folder.png"));
  ASSERT_TRUE(waitFor([&] { return page.messages().isVisible(); }));
  EXPECT_TRUE(page.messages().text().contains("folder.png"));
  page.messages().hide();
  page.saveData(folder.filePath("a.txt"));
  ASSERT_TRUE(waitFor([&] { return page.messages().isVisible(); }));
  EXPECT_TRUE(page.messages().text().contains(".csv"));
  EXPECT_FALSE(QFile::exists(folder.filePath("a.txt")));
}

TEST_F(PageTest, WhyAFileWasNotWrittenStaysWhileTheFigureIsComputedAgain) {
  bool isEndless = false;
  FiguresPage& page = show([&](FigureName name, const FigureOptions& options) {
    if (!isEndless) return quickFigure(name, options);
    for (double part = 0; !options.stop.stop_requested(); part += 0.001) {
      options.progress(part);
      QThread::msleep(2);
    }
    throw StopRequested{};
  });
  page.choose(FigureName::Plateau, true);
  ASSERT_TRUE(waitUntilMade(FigureName::Plateau));
  isEndless = true;
  click("compute");
  ASSERT_TRUE(waitFor([&] { return isComputing(FigureName::Plateau); }));
  page.savePicture("/nowhere/plateau.png");
  ASSERT_TRUE(waitFor([&] { return page.messages().text().contains("plateau.png"); }));
  const double part = status(FigureName::Plateau).part;
  ASSERT_TRUE(waitFor([&] { return status(FigureName::Plateau).part > part + 0.01; }));
  EXPECT_TRUE(page.messages().isVisible());
}

TEST_F(PageTest, GoesAwayInTheMiddleOfAComputation) {
  show(endlessFigure).choose(FigureName::Hurst, true);
  ASSERT_TRUE(waitFor([&] { return isComputing(FigureName::Hurst); }));
  page_.reset();  // the test ends only if this does
}

TEST_F(PageTest, ControlsHaveNames) {
  show(quickFigure);
  for (QWidget* widget : page_->findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible()) continue;
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) {
      EXPECT_FALSE(button->text().isEmpty());
    } else if (widget->parentWidget() == page_.get() || qobject_cast<QAbstractItemView*>(widget) ||
               qobject_cast<QSpinBox*>(widget)) {
      EXPECT_FALSE(widget->accessibleName().isEmpty()) << qPrintable(widget->objectName());
    }
  }
}

}  // namespace
}  // namespace asperity
