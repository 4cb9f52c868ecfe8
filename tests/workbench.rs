//! The workbench: over plain sockets, and in a real browser.

#[path = "workbench/browser.rs"]
mod browser;
#[path = "workbench/limits.rs"]
mod limits;
#[path = "workbench/page.rs"]
mod page;
#[path = "workbench/server.rs"]
mod server;
