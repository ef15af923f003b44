//! The keywords of OBJ that carry no triangles.

/// Lines of these are passed over without a word.
pub(super) const SILENT: [&str; 14] = [
    "o",
    "g",
    "s",
    "mg",
    "vp",
    "usemtl",
    "usemap",
    "maplib",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
];

/// Lines of these are counted in the notes, each with what it would be.
pub(super) const COUNTED: [&str; 26] = [
    "mtllib", "p", "l", "curv", "curv2", "surf", "cstype", "deg", "bmat", "step", "parm", "trim", "hole", "scrv", "sp",
    "end", "con", "ctech", "stech", "call", "csh", "bzp", "bsp", "cdc", "cdp", "res",
];
