// One call of `asperity` beside the window, as a process of its own: the window goes on whatever
// the call does, and a call that was cancelled leaves no half file. The newest call wins: an older
// one is ended first. GUI thread; belongs to its parent. Failure: the call's own sentence.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QPointer>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace asperity {

class CommandRun : public QObject {
  Q_OBJECT

 public:
  /// program: what is run; empty: this program.
  explicit CommandRun(const QString& program, QObject* parent = nullptr);
  ~CommandRun() override;

  /// Runs the words, of which the first one, "asperity", stands for the program, in this folder.
  void run(const QStringList& words, const QString& folder);
  void cancel();
  bool isRunning() const { return process_ != nullptr; }

 signals:
  /// Emitted when the newest call has ended well, with its standard output.
  void done(const QByteArray& output);
  /// Emitted when it has failed.
  void failed(const QString& reason);
  /// Emitted with the finished part, 0 to 1, of the "frames" or what else is counted.
  void progressed(double part, const QString& of);

 private:
  void readErrors();
  void finish(int status, bool hasCrashed);

  QString program_;
  QPointer<QProcess> process_;
  QByteArray errors_;
};

}  // namespace asperity
