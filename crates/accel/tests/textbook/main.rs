//! The textbook, structure by structure: one program, since every test program compiles each structure anew.

mod answers;
mod bsp;
mod fitting;
mod grids;
mod growth;
mod instancing;
mod kd_builds;
mod layouts;
mod lecture_numbers;
mod limits;
mod mistakes;
mod objects;
mod octree;
mod overlaps;
mod packets;
mod solids;
mod spell;
mod stories;
mod volumes;
