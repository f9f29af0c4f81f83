# SPDX-License-Identifier: MIT
# Landmark files read and written by R alone, after the descriptions of their formats: Rscript formats.R read|write FOLDER
# read: bear.tps, bear.pts and bear.txt (Morphologika) become bear.tps.csv, ...; write: such files with the points of points.csv.

read_tps <- function(path) {
  lines <- readLines(path)
  head <- grep("^LM3=", lines)
  count <- as.integer(sub("^LM3=", "", lines[head]))
  as.matrix(read.table(text = lines[head + seq_len(count)]))
}

read_pts <- function(path) {
  points <- as.matrix(read.table(path, skip = 2, row.names = 1))
  points[points == 9999] <- NA
  points
}

read_morphologika <- function(path) {
  lines <- readLines(path)
  lines <- lines[!grepl('^"', lines) & nzchar(lines)]
  after <- function(section) lines[match(section, lines) + 1]
  count <- as.integer(after("[landmarks]"))
  stopifnot(after("[individuals]") == "1", after("[dimensions]") == "3", startsWith(after("[rawpoints]"), "'"))
  as.matrix(read.table(text = lines[match("[rawpoints]", lines) + 1 + seq_len(count)]))
}

rows_of <- function(points) apply(format(points, digits = 17, trim = TRUE), 1, paste, collapse = " ")

write_tps <- function(points, path) {
  writeLines(c(paste0("LM3=", nrow(points)), rows_of(points), "ID=bear", ""), path)
}

write_pts <- function(points, path) {
  points[is.na(points)] <- 9999
  writeLines(c("Version 1.0", nrow(points), paste(sprintf("S%03d", seq_len(nrow(points)) - 1), rows_of(points))), path)
}

write_morphologika <- function(points, path) {
  writeLines(c("[individuals]", 1, "[landmarks]", nrow(points), "[dimensions]", 3, "[names]", "bear", "[rawpoints]", "'bear", rows_of(points)), path)
}

arguments <- commandArgs(trailingOnly = TRUE)
setwd(arguments[2])
if (arguments[1] == "read") {
  for (name in c("bear.tps", "bear.pts", "bear.txt")) {
    points <- switch(tools::file_ext(name), tps = read_tps(name), pts = read_pts(name), txt = read_morphologika(name))
    write.table(format(points, digits = 17), paste0(name, ".csv"), sep = ",", quote = FALSE, row.names = FALSE, col.names = FALSE)
  }
} else {
  points <- as.matrix(read.csv("points.csv", header = FALSE))
  write_tps(points, "bear.tps")
  write_pts(points, "bear.pts")
  write_morphologika(points, "bear.txt")
}
