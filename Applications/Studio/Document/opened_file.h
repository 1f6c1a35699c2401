// Files that have been read, on any thread, and are not shown yet.
#ifndef oversketch_applications_studio_document_opened_file_h
#define oversketch_applications_studio_document_opened_file_h

#include "look.h"
#include "picture_files.h"
#include "session.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

namespace oversketch_studio
{

// A mesh or a session.
struct OpenedFile
{
  oversketch_session::Session session;
  std::optional<oversketch_session::Look> look;
  QString path;                        // of a session's file
  std::vector<SharedPicture> pictures; // that are seen at once
  QStringList notes;
  int upAxis = 1; // of the world: 1 for y, 2 for z
};

// The step of a drawing over a picture, which is decoded.
struct OpenedDrawing
{
  std::shared_ptr<const oversketch_session::Step> step;
  SharedPicture picture;
};

} // namespace oversketch_studio
#endif
