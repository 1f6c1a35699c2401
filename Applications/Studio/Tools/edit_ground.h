// What an edit acts on that later steps act on: the document's thread makes it when it is asked for, as only
// what the last step acts on comes with each result.
#ifndef oversketch_applications_studio_tools_edit_ground_h
#define oversketch_applications_studio_tools_edit_ground_h

#include "session.h"
#include "worker.h"

#include <QObject>
#include <QStringList>

#include <cstdint>
#include <vector>

namespace oversketch_studio
{

class Document;

class EditGround : public QObject
{
  Q_OBJECT

public:
  explicit EditGround(const Document* document, QObject* parent = nullptr);

  // Of the step with that id; null where it is on its way, and came() follows.
  const oversketch_session::Worker::Ground* of(int id);
  // Names of the steps after it that do nothing, or act elsewhere than they did.
  QStringList lost(int id) const;

signals:
  void came();

private:
  // What it is of: the mesh that is opened, the steps until there, and where they run.
  struct Place
  {
    oversketch_session::SharedData mesh;
    std::vector<oversketch_session::Node> nodes;
    int backend = 0;
  };
  bool isSame(const Place& place) const;

  const Document* OpenDocument;
  Place Asked;
  std::uint64_t Number = 0; // of the asking; 0: it has come
  oversketch_session::Worker::Ground Came;
};

} // namespace oversketch_studio
#endif
