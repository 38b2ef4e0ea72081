// Resolves one movie and writes its result folder.
// In ImageJ: Plugins > Macros > Run...; without a display:
//   fiji --headless -macro resolve-one.ijm "/data/movie.tif,/data/result"
arguments = split(getArgument(), ",");
if (arguments.length == 2) {
	movie = arguments[0];
	out = arguments[1];
} else {
	movie = File.openDialog("Movie");
	out = getDirectory("Folder for the result") + "result";
}
open(movie);
run("Resolve Filament...", "threshold=otsu out=[" + out + "] force");
