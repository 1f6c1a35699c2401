// A hand on the window, at random: strokes, mouse, pen, fingers, keys, rows, menus, files, and answers to
// what is asked.
#ifndef oversketch_applications_studio_testing_hand_h
#define oversketch_applications_studio_testing_hand_h

#include <QObject>
#include <QPoint>
#include <QString>
#include <QStringList>

#include <random>
#include <string>
#include <vector>

class QFileDialog;
class QTouchDevice;
class QWidget;

namespace oversketch_studio
{

class Document;
class MainWindow;
class Viewport;

class Hand : public QObject
{
public:
  // What came of it.
  struct Deeds
  {
    int strokes = 0; // drawn
    int moved = 0;   // strokes moved or drawn over in part
    int undone = 0, redone = 0;
    int meshes = 0; // shown, other than the one before
    int questions = 0;
    int opened = 0;
    int lines = 0;                 // drawn over a picture, or taken off it
    int partDrags = 0, placed = 0; // drags of a part's handle, and those that have moved it
    int edits = 0;                 // changes of an edit by hand
    int looks = 0, looked = 0;     // gestures of the camera, and those that have moved it
    int rows = 0, ordered = 0;     // drags in the history, and those that have changed it
    int glances = 0;               // at the model before a step
    int pressed = 0, touched = 0;  // lines with a pen's pressure, gestures of fingers
    int menus = 0;                 // opened

    void add(const Deeds& other);
  };

  // All that it does is made of the seed; files are of the folder.
  Hand(unsigned seed, MainWindow& window, const QString& folder);

  // From here on it draws over the picture and moves its part more than it draws on the model.
  void keepToDrawing() { this->Draws = true; }

  // Does one thing of a few events, and returns how many.
  int act();
  const Deeds& deeds() const { return this->Doing; }
  // What the window said was wrong; not that a file is damaged that is.
  const QStringList& complaints() const { return this->Complaints; }
  // What is being computed, and how far it is.
  const QString& stage() const { return this->Stage; }

  // A file that no reader takes.
  static const char* const damaged;

private:
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(this->Random); }
  bool oneIn(int times) { return this->upTo(times - 1) == 0; }
  QPoint place(QWidget* on);
  QPoint near(const QPoint& place, int distance);
  QString file();

  int strokeBesideTheModel();
  int dragOfTheStroke();
  int editOfARegion();
  int line(QWidget* on, const std::vector<QPoint>& way, Qt::KeyboardModifiers held = Qt::NoModifier);
  int lineOnThePad();
  int dragOfAPart();
  int lineWithAPen();
  int fingers();
  int look();
  int glance();
  int dragInTheHistory();
  int keyInTheHistory();
  int menu();
  int option();
  int press();
  int key();
  int undoAndRedo();
  int wheel();
  int click();
  int menuEntry();
  int drop();
  void answer();
  void answerPopup(QWidget* popup);
  void answerFile(QFileDialog* dialog);

  std::mt19937 Random;
  MainWindow& Window;
  Viewport* View;
  Document* OpenDocument;
  QString Folder, Stage;
  QStringList Complaints;
  Deeds Doing;
  std::string Shown; // digest
  bool Answering = false, Draws = false;
};

} // namespace oversketch_studio
#endif
