package io.github.knotresolver.command;

import org.scijava.Priority;
import org.scijava.module.Module;
import org.scijava.module.ModuleItem;
import org.scijava.module.process.AbstractPostprocessorPlugin;
import org.scijava.module.process.PostprocessorPlugin;
import org.scijava.plugin.Plugin;

/**
 * Tells SciJava that this program's Commands show their outputs themselves, so that it neither shows
 * them again nor, without a display, complains that it cannot.
 */
@Plugin(type = PostprocessorPlugin.class, priority = Priority.HIGH)
public class ShownOutputs extends AbstractPostprocessorPlugin {

	@Override
	public void process(final Module module) {
		if (module.getDelegateObject() instanceof KnotCommand)
			for (final ModuleItem<?> output : module.getInfo().outputs())
				module.resolveOutput(output.getName());
	}
}
