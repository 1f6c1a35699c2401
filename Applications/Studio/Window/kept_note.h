// When the work was last put on the disk: in its own file, or, for the case of a crash, beside.
#ifndef oversketch_applications_studio_window_kept_note_h
#define oversketch_applications_studio_window_kept_note_h

#include <QLabel>

namespace oversketch_studio
{

class Document;

class KeptNote : public QLabel
{
  Q_OBJECT

public:
  explicit KeptNote(const Document* document, QWidget* parent = nullptr);

private:
  void follow();

  const Document* OpenDocument;
  bool Saved = false; // since it was opened
};

} // namespace oversketch_studio
#endif
