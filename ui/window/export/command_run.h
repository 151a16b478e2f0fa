// A call of `asperity` (asperity_command.h) as a process of its own. GUI thread.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QPointer>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace asperity {

/// The height of a picture that was refused, and one that is enough, in pixels. 0: it was not too
/// low.
struct NeededHeight {
  int given = 0, enough = 0;
};

/// One call as a process: the window stays responsive, and a cancelled call leaves no incomplete
/// file. The newest call wins: an older one is ended first. Owned by its parent. Failure: the error
/// message of the call.
class CommandRun : public QObject {
  Q_OBJECT

 public:
  /// program: the executable; empty: this program.
  explicit CommandRun(const QString& program, QObject* parent = nullptr);
  ~CommandRun() override;

  /// Runs the words in this folder; the first one, "asperity", is the name of the program.
  void run(const QStringList& words, const QString& folder);
  void cancel();
  bool isRunning() const { return process_ != nullptr; }

 signals:
  /// Emitted when the newest call has ended well, with its standard output.
  void done(const QByteArray& output);
  /// Emitted when it has failed.
  void failed(const QString& reason, const NeededHeight& height);
  /// Emitted with the finished part, 0 to 1, and the name of what is counted, such as "frames".
  void progressed(double part, const QString& of);

 private:
  void readErrors();
  void finish(int status, bool hasCrashed);

  QString program_;
  QPointer<QProcess> process_;
  QByteArray errors_;
  NeededHeight height_;
};

}  // namespace asperity
