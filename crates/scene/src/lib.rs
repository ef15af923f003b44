//! What rays meet: meshes, patches, flat scenes, and the reader that guards them.
