#include "tests/bench/window/window_measures.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <ctime>
#include <functional>
#include <stdexcept>

#include "tests/ui/window/fresh_paints.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/pixel_context.h"
#include "ui/panels/value_slider.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/scene_document.h"

namespace asperity::bench {
namespace {

constexpr int kPatience = 60000;  // ms

double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

/// Returns the processor time of this process, s.
double processorTime() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void wait(int milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  loop.exec();
}

// ---- the start
// ------------------------------------------------------------------------------------

/// Seconds that the program's own clock says after a name.
double timeIn(const QString& text, const QString& name) {
  const QRegularExpression line(name + QStringLiteral(" after ([0-9.]+) s"));
  const QRegularExpressionMatch found = line.match(text);
  return found.hasMatch() ? found.captured(1).toDouble() : -1;
}

struct StartTime {
  double window = 0, curve = 0;  // ms
};

StartTime startOnce() {
  QProcess program;
  program.setProcessChannelMode(QProcess::MergedChannels);
  program.start(QStringLiteral(ASPERITY_PROGRAM), {QStringLiteral("--timing")});
  QString said;
  StartTime time{-1, -1};
  while ((time.window < 0 || time.curve < 0) && program.waitForReadyRead(kPatience)) {
    said += QString::fromUtf8(program.readAll());
    time = {timeIn(said, QStringLiteral("window on the screen")),
            timeIn(said, QStringLiteral("first curve"))};
  }
  program.kill();
  program.waitForFinished(kPatience);
  if (time.window < 0 || time.curve < 0)
    throw std::runtime_error("the window did not start: " + said.toStdString());
  return {1e3 * time.window, 1e3 * time.curve};
}

void measureStart(int runs, std::vector<WindowMeasure>& measures) {
  startOnce();  // fills the cache of files
  std::vector<double> windows, curves;
  for (int i = 0; i < runs; ++i) {
    const StartTime time = startOnce();
    windows.push_back(time.window);
    curves.push_back(time.curve);
  }
  measures.push_back(
      {"window on the screen, from the start, median", "ms", true, 500, quantile(windows, 0.5)});
  measures.push_back(
      {"first curve, from the start, median", "ms", true, 1000, quantile(curves, 0.5)});
}

// ---- sliders
// --------------------------------------------------------------------------------------

class Window {
 public:
  Window() : window_(Scene{}) {
    window_.resize(1280, 720);
    window_.show();
    wait(500);
  }

  void useScheme(Scheme scheme, int oversampling) {
    Scene scene;
    scene.accuracy.scheme = scheme;
    scene.accuracy.oversampling = oversampling;
    window_.document().open(scene);
    waitUntilDone();
  }

  /// From a step of a slider to the picture of the first new curve (ms each). The ensemble before
  /// it still runs, as while a person drags.
  std::vector<double> firstCurves(int count) {
    auto& slider = *window_.findChild<ValueSlider*>("slider:elastomer.shear_modulus");
    FreshPaints paints(window_.session(), window_.plotView());
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
      wait(20);
      paints.start();
      QTest::keyClick(&slider, i % 2 == 0 ? Qt::Key_Right : Qt::Key_Left);
      if (!paints.waitForPicture()) throw std::runtime_error("no new curve was painted");
      times.push_back(paints.milliseconds);
    }
    return times;
  }

  /// From a step of a slider until all realizations are averaged (ms each).
  std::vector<double> wholeCurves(int count) {
    auto& slider = *window_.findChild<ValueSlider*>("slider:elastomer.shear_modulus");
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
      wait(50);
      QElapsedTimer clock;
      clock.start();
      QTest::keyClick(&slider, i % 2 == 0 ? Qt::Key_Right : Qt::Key_Left);
      waitUntilDone();
      times.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
    }
    return times;
  }

  void resize(const QSize& size) {
    window_.resize(size);
    wait(200);
  }

  /// Makes the contact view of a size or a little larger: the window gives a share to each part.
  void resizeContact(const QSize& size) {
    const auto missing = [&] { return (size - window_.canvas().size()).expandedTo({0, 0}); };
    for (int i = 0; i < 40 && !missing().isNull(); ++i) {
      window_.resize(window_.size() + missing());
      wait(50);
    }
    if (!missing().isNull()) throw std::runtime_error("no contact view of this size");
  }

  /// Pictures of the contact a second while ensembles run without a pause.
  double picturesPerSecond(int milliseconds) {
    const QObject context;
    const auto goOn = [this] {
      if (window_.session().averaging() == Session::Averaging::Done) window_.session().startCurve();
    };
    QObject::connect(&window_.session(), &Session::plotChanged, &context, goOn);
    goOn();
    wait(1000);
    int pictures = 0;
    QObject::connect(&window_.canvas(), &ContactCanvas::painted, &context, [&] { ++pictures; });
    QElapsedTimer clock;
    clock.start();
    wait(milliseconds);
    return 1e9 * pictures / static_cast<double>(clock.nsecsElapsed());
  }

  /// The animation of the contact while no curve is computed.
  struct Animation {
    double picturesPerSecond = 0;
    double cost = 0;  // ms, processor time of the whole window for a picture
  };
  Animation animation(int milliseconds) {
    waitUntilDone();
    wait(500);
    const QObject context;
    int pictures = 0;
    QObject::connect(&window_.canvas(), &ContactCanvas::painted, &context, [&] { ++pictures; });
    QElapsedTimer clock;
    clock.start();
    const double before = processorTime();
    wait(milliseconds);
    return {1e9 * pictures / static_cast<double>(clock.nsecsElapsed()),
            1e3 * (processorTime() - before) / std::max(pictures, 1)};
  }

  /// Part of a processor that the paused window takes, %.
  double restingLoad(int milliseconds) {
    waitUntilDone();
    window_.session().setPlaying(false);
    wait(2500);
    QElapsedTimer clock;
    clock.start();
    const double before = processorTime();
    wait(milliseconds);
    const double load =
        1e11 * (processorTime() - before) / static_cast<double>(clock.nsecsElapsed());
    window_.session().setPlaying(true);
    return load;
  }

  std::shared_ptr<const Frame> frame() { return window_.session().frame(); }

 private:
  void waitUntilDone() {
    Session& session = window_.session();
    const auto isDone = [&] { return session.averaging() == Session::Averaging::Done; };
    QEventLoop loop;
    const QMetaObject::Connection told =
        QObject::connect(&session, &Session::plotChanged, &loop, [&] {
          if (isDone()) loop.quit();
        });
    QTimer::singleShot(kPatience, &loop, &QEventLoop::quit);
    if (!isDone()) loop.exec();
    if (!isDone()) throw std::runtime_error("the curve was not averaged in time");
  }

  MainWindow window_;
};

void measureSliders(Window& window, bool isQuick, std::vector<WindowMeasure>& measures) {
  struct Case {
    const char* name;
    Scheme scheme;
    int oversampling;
    double limit;
  };
  for (const Case& one :
       {Case{"`nodal`", Scheme::Nodal, 1, 200}, Case{"`cubic` x2", Scheme::Cubic, 2, 1000}}) {
    window.useScheme(one.scheme, one.oversampling);
    const std::vector<double> first = window.firstCurves(isQuick ? 20 : 200);
    const std::string name = std::string(", ") + one.name;
    measures.push_back({"slider to the first new curve painted, median" + name, "ms", true, 16,
                        quantile(first, 0.5)});
    measures.push_back({"slider to the first new curve painted, 19 of 20" + name, "ms", true, 16,
                        quantile(first, 0.95)});
    measures.push_back({"slider to all 200 realizations, median" + name, "ms", true, one.limit,
                        quantile(window.wholeCurves(isQuick ? 3 : 15), 0.5)});
  }
}

void measurePictures(Window& window, bool isQuick, std::vector<WindowMeasure>& measures) {
  const int time = isQuick ? 1000 : 5000;
  measures.push_back({"pictures of the contact, window of 1280x720, ensemble running", "1/s", false,
                      30, window.picturesPerSecond(time)});
  window.resize({2560, 1440});
  measures.push_back({"the same, window of 2560x1440", "1/s", false, std::nullopt,
                      window.picturesPerSecond(time)});
  window.resize({1280, 720});
  window.resizeContact({1280, 720});
  measures.push_back({"pictures of the contact, 1280x720 of their own, ensemble running", "1/s",
                      false, 30, window.picturesPerSecond(time)});
}

/// Where the processor time of a frame goes that is written at 1920x1080: each part alone.
void measureShares(const Frame& frame, bool isQuick, std::vector<WindowMeasure>& measures) {
  ContactPictureOptions options;
  options.width = 1920;
  options.height = 1080;
  const int pictures = isQuick ? 10 : 60;
  const auto context = makeRasterContext();
  double compose = 0, shapes = 0, texts = 0, encode = 0;
  const auto timed = [](double& sum, const auto& work) {
    const double before = processorTime();
    auto made = work();
    sum += processorTime() - before;
    return made;
  };
  for (int i = 0; i < pictures; ++i) {
    const DrawList list = timed(compose, [&] { return composeContact(frame, options); });
    const Pixels pixels = timed(shapes, [&] { return context->draw(list); });
    QImage image(pixels.rgba.data(), pixels.width, pixels.height, 4 * pixels.width,
                 QImage::Format_RGBA8888_Premultiplied);
    image.detach();
    timed(texts, [&] {
      QPainter painter(&image);
      paintTexts(painter, list);
      return true;
    });
    timed(encode, [&] { return encodePng(image, {}); });
  }
  const double whole = compose + shapes + texts + encode;
  measures.push_back(
      {"processor time of a frame written at 1920x1080", "ms", true, 44, 1e3 * whole / pictures});
  const auto share = [&](const char* name, double part) {
    measures.push_back(
        {std::string("its share: ") + name, "%", true, std::nullopt, 100 * part / whole});
  };
  share("compose", compose);
  share("shapes", shapes);
  share("texts", texts);
  share("encode", encode);
}

void measureCosts(Window& window, bool isQuick, std::vector<WindowMeasure>& measures) {
  const int time = isQuick ? 1000 : 5000;
  struct Case {
    QSize size;
    const char* name;
    double limit;
  };
  for (const Case& one :
       {Case{{1600, 1000}, "1600x1000", 55}, Case{{2560, 1440}, "2560x1440", 50}}) {
    window.resize(one.size);
    const Window::Animation animation = window.animation(time);
    const std::string name = std::string("window of ") + one.name;
    measures.push_back(
        {"pictures of the contact, " + name, "1/s", false, one.limit, animation.picturesPerSecond});
    measures.push_back(
        {"processor time of a picture, " + name, "ms", true, std::nullopt, animation.cost});
  }
  window.resize({1280, 720});
  measures.push_back(
      {"processor time of the paused window", "%", true, 0.5, window.restingLoad(time)});
  measureShares(*window.frame(), isQuick, measures);
}

}  // namespace

std::vector<WindowMeasure> measureWindow(bool isQuick) {
  std::vector<WindowMeasure> measures;
  measureStart(isQuick ? 2 : 9, measures);
  Window window;
  measureSliders(window, isQuick, measures);
  measurePictures(window, isQuick, measures);
  measureCosts(window, isQuick, measures);
  return measures;
}

}  // namespace asperity::bench
