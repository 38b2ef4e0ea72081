// Resolves every movie of a folder, each into its own result folder.
// A movie that fails is reported in batch.csv, and the rest go on.
arguments = split(getArgument(), ",");
if (arguments.length == 2) {
	input = arguments[0];
	out = arguments[1];
} else {
	input = getDirectory("Folder of movies");
	out = getDirectory("Folder for the results");
}
run("Batch...", "input=[" + input + "] out=[" + out + "] options=[threshold=otsu]");
